# The tests of the examples, for ctest. Each example is a project of its own, which is built as a user builds it, with
# all that it uses, and so is for thorough runs, but for the page. By default it is also tested that the tests of the
# screens can fail.
foreach(example Screens Webgl Raylib Vulkan Bevy Cuda)
  string(TOLOWER ${example} name)
  if(NOT example STREQUAL Screens AND NOT EXISTS ${CMAKE_CURRENT_LIST_DIR}/${name})
    continue()
  endif()
  set(when CONFIGURATIONS Thorough)
  if(example MATCHES "Screens|Webgl")
    set(when)
  endif()
  add_test(NAME examples.${name} ${when} COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/examples_test.py
                                         ${PROJECT_BINARY_DIR}/examples-tests ${example})
  set_tests_properties(examples.${name} PROPERTIES SKIP_RETURN_CODE 77)
endforeach()
