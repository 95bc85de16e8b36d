# The commands of docs/guide/build-systems.md run in an empty folder, and the game that comes of it computes golden
# values.
set(work ${PROJECT_BINARY_DIR}/build-systems-tests)
# Each way builds the library anew, and so is for thorough runs.
add_test(NAME build_systems.environment CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/environment.py ${work}/environment)
set_tests_properties(build_systems.environment PROPERTIES FIXTURES_SETUP build_systems SKIP_RETURN_CODE 77)
foreach(subject Files CMake OldestCMake Meson Conan Vcpkg)
  string(TOLOWER ${subject} name)
  if(subject MATCHES "Conan|Vcpkg" AND NOT EXISTS ${PROJECT_SOURCE_DIR}/packages/${name})
    continue()
  endif()
  set(when CONFIGURATIONS Thorough)
  if(subject STREQUAL Files)
    set(when)
  endif()
  add_test(NAME build_systems.${name} ${when}
           COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/build_systems_test.py
                   ${work}/environment ${work}/projects ${subject})
  set_tests_properties(build_systems.${name} PROPERTIES SKIP_RETURN_CODE 77)
  if(subject MATCHES "OldestCMake|Meson|Conan")
    set_tests_properties(build_systems.${name} PROPERTIES FIXTURES_REQUIRED build_systems)
  endif()
endforeach()
