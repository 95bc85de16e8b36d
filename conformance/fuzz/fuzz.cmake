# A program per parser for libFuzzer, which comes with Clang. They link the parsers only, so that they are built in
# seconds: no twins, no drivers, no glslang.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
  message(FATAL_ERROR "HASHNOISE_FUZZ needs Clang; the preset fuzz names it")
endif()

# -fsanitize=undefined leaves out conversions of floats to integers that cannot hold them. The assertions
# of the standard library tell where a string_view is overrun.
set(sanitizers -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all)
add_library(fuzzed STATIC
  expectation.cpp functions.cpp golden.cpp journal.cpp json_reader.cpp merge.cpp options.cpp
  outcome.cpp profile.cpp results.cpp runner.cpp source.cpp
  kEmbeddedFiles.cpp kResources.cpp)
target_include_directories(fuzzed PUBLIC ${CMAKE_CURRENT_SOURCE_DIR} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
target_compile_definitions(fuzzed PUBLIC _GLIBCXX_ASSERTIONS)
target_compile_options(fuzzed PUBLIC ${warnings} ${sanitizers} -fsanitize=fuzzer-no-link -O1 -gline-tables-only)
target_link_options(fuzzed PUBLIC ${sanitizers})
target_link_libraries(fuzzed PUBLIC hashnoise::hashnoise glad fmt::fmt nlohmann_json::nlohmann_json tl::expected
                             PRIVATE CLI11::CLI11)

add_custom_target(fuzzers)
foreach(target expectations golden journal options results shaders)
  add_executable(fuzz-${target} EXCLUDE_FROM_ALL fuzz/${target}.cpp)
  target_link_libraries(fuzz-${target} PRIVATE fuzzed)
  target_link_options(fuzz-${target} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzzers fuzz-${target})
endforeach()
