# Every test, for ctest. Names are subject.case.
find_package(GTest REQUIRED)
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
include(GoogleTest)

# --- The parts of hn-conform ---
add_executable(conform-test
  evidence_test.cpp junit_test.cpp report_page_test.cpp output/base64_test.cpp output/text_test.cpp
  compare_test.cpp expectation_test.cpp golden_test.cpp gpu_test.cpp journal_test.cpp merge_test.cpp metamorphic_checks_test.cpp options_test.cpp points_test.cpp profile_test.cpp property_checks_test.cpp reference_compiler_test.cpp
  report_test.cpp results_test.cpp runner_test.cpp scheduler_test.cpp source_test.cpp bugs/bugs_test.cpp fault/inject_test.cpp
  fault/rewriter_test.cpp tolerance_test.cpp twin_test.cpp
  bench/amd_test.cpp bench/bench_test.cpp bench/counts_test.cpp bench/subject_test.cpp bench/tables_test.cpp
  bench/timing_test.cpp output/csv_test.cpp output/number_test.cpp output/page_test.cpp output/png_test.cpp output/svg_test.cpp
  paper/algorithm_test.cpp paper/period_test.cpp paper/published_test.cpp paper/statistics_test.cpp
  web/browser_loss_test.cpp web/browser_test.cpp web/suite_test.cpp)
add_dependencies(conform-test hn-conform)  # which counts for AMD in a process of its own
target_compile_definitions(conform-test PRIVATE HN_CONFORM_PROGRAM="$<TARGET_FILE:hn-conform>")
target_compile_definitions(conform-test PRIVATE HN_GOLDEN_DIRECTORY="${CMAKE_CURRENT_SOURCE_DIR}/golden")
target_link_libraries(conform-test PRIVATE conform-lib pugixml::pugixml GTest::gtest_main)
gtest_discover_tests(conform-test TEST_PREFIX unit. TEST_FILTER "-Timing.*:Stopwatched.*")
gtest_discover_tests(conform-test TEST_PREFIX unit. TEST_FILTER "Timing.*:Stopwatched.*" TEST_LIST timed_tests
                     PROPERTIES RUN_SERIAL ON)

# --- The program, as its user meets it ---
add_test(NAME cli COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/cli_test.py $<TARGET_FILE:hn-conform>)
add_test(NAME cli_bench COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/bench_cli_test.py $<TARGET_FILE:hn-conform>)
add_test(NAME cli_paper COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/paper_cli_test.py $<TARGET_FILE:hn-conform>)
add_test(NAME cli_run COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/run_cli_test.py $<TARGET_FILE:hn-conform>)
add_test(NAME cli_web COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/web_cli_test.py $<TARGET_FILE:hn-conform>)

# --- The library on this machine's drivers ---
# Named, so that one that is missing is no success.
set(drivers osmesa egl egl-gles egl-device:0 egl-device:0-gles softpipe softpipe-gles zink zink-gles
    glfw glfw-gles glfw-egl glfw-egl-gles glfw-osmesa webgl2 webgl2-mesa)
list(TRANSFORM drivers PREPEND "--driver=" OUTPUT_VARIABLE driver_options)
add_test(NAME conform.all COMMAND hn-conform run ${driver_options} --out ${CMAKE_CURRENT_BINARY_DIR}/out-all)
set_tests_properties(conform.all PROPERTIES TIMEOUT 1200)

# --- The oracle and the tools ---
set(tools ${PROJECT_SOURCE_DIR}/tools)
foreach(test oracle oracle_fixed golden bounds bounds_float bounds_fixed faults fuzz mutate mutation_rules single_file umbrella)
  add_test(NAME tools.${test} COMMAND Python3::Interpreter ${tools}/${test}_test.py)
endforeach()
add_test(NAME golden.regenerated_is_committed COMMAND Python3::Interpreter ${tools}/golden --check)
# The suite must notice a change of the library; all of them by command, a few here.
add_test(NAME mutants.sample COMMAND Python3::Interpreter ${tools}/mutate --program $<TARGET_FILE:hn-conform> --sample 30)

# Each test of the randomness rejects what it should, and every hash passes them all. (In full by command.)
add_test(NAME tools.quality COMMAND ${tools}/scientific-python ${tools}/quality_test.py)
add_test(NAME tools.default_hash COMMAND ${tools}/scientific-python ${tools}/default_hash_test.py)
add_test(NAME quality.gate COMMAND ${tools}/quality --quick)

# Every fault that drivers have had turns a run red, and docs/faults.md says by which cases.
add_test(NAME faults.table_is_committed COMMAND Python3::Interpreter ${tools}/faults --check --program $<TARGET_FILE:hn-conform>)
# The parsers take anything: by command for long, a little here. The fuzzers are built on the way.
add_test(NAME fuzz.corpus COMMAND Python3::Interpreter ${tools}/fuzz --runs 2000 --build ${PROJECT_BINARY_DIR}/fuzz)

# tools/test runs as many tests at a time as there are cores. These use all of them by themselves, or measure times.
set_tests_properties(cli_bench cli_paper cli_run cli_web conform.all mutants.sample faults.table_is_committed quality.gate
                     PROPERTIES RUN_SERIAL ON)

# --- The C++ twin in other hands ---
add_test(NAME consumer.find_package
         COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DWORK=${CMAKE_CURRENT_BINARY_DIR}/consumer -DGENERATOR=${CMAKE_GENERATOR}
                 -P ${CMAKE_CURRENT_SOURCE_DIR}/consumer/test.cmake)
foreach(compiler g++ clang++)
  find_program(COMPILER_${compiler} ${compiler} REQUIRED)
  foreach(configuration ${configurations})
    separate_arguments(macros UNIX_COMMAND "${configuration}")
    list(POP_FRONT macros name)
    list(TRANSFORM macros PREPEND "-D")
    add_test(NAME twin.warnings.${compiler}.${name}
             COMMAND ${COMPILER_${compiler}} -std=c++20 -fsyntax-only -Wall -Wextra -Wconversion -Wshadow
                     -Wdouble-promotion -Wsign-conversion -Wold-style-cast -Wpedantic -Werror
                     ${macros} "-DHN_HASH_FN(k)=(k)" -I ${PROJECT_SOURCE_DIR}/include
                     ${CMAKE_CURRENT_SOURCE_DIR}/consumer/main.cpp)
  endforeach()
endforeach()

# The text in other languages, and over other numbers.
add_test(NAME text.hlsl COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/testing/hlsl_test.py)
add_test(NAME text.lanes COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/testing/lanes_test.py
                                 ${COMPILER_g++} ${COMPILER_clang++})

add_test(NAME twin.flags COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/twin_flags_test.py
                                 ${COMPILER_g++} ${COMPILER_clang++})

# --- The README: its picture and its code ---
add_executable(picture ${tools}/picture.cpp)
target_compile_options(picture PRIVATE ${warnings} -ffp-contract=off)
target_link_libraries(picture PRIVATE hashnoise::hashnoise PNG::PNG)
add_test(NAME readme COMMAND Python3::Interpreter ${tools}/readme_test.py $<TARGET_FILE:picture>)
