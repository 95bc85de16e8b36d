# The tests of the playground: the page as tools/playground makes it, in Node.js and in Chromium.
set(playground_page ${PROJECT_BINARY_DIR}/playground/playground.html)
add_test(NAME playground.page COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/playground --out ${playground_page})
set_tests_properties(playground.page PROPERTIES FIXTURES_SETUP playground_page)

# model, layers, files, values and relief run without a browser; pixels and code want g++ and glslang besides.
foreach(subject model layers files values relief pixels code input)
  add_test(NAME playground.${subject}
           COMMAND ${javascript} node ${CMAKE_CURRENT_LIST_DIR}/tests/${subject}_test.mjs ${playground_page})
  set_tests_properties(playground.${subject} PROPERTIES FIXTURES_REQUIRED "javascript;playground_page" SKIP_RETURN_CODE 77
                                                        TIMEOUT 600)
endforeach()
set_tests_properties(playground.input PROPERTIES ENVIRONMENT HN_BESIDE_OTHERS=1)
# They take long, and so begin early, also on a machine where ctest knows no times yet.
set_tests_properties(playground.input playground.code playground.pixels PROPERTIES COST 30)
set_tests_properties(playground.code PROPERTIES TIMEOUT 1800)  # of a thorough run: it draws fifty settings in two languages
# Two of these tests measure times: for half a minute nothing else may run, so they are for thorough runs.
add_test(NAME playground.times CONFIGURATIONS Thorough
         COMMAND ${javascript} node --test-name-pattern=time ${CMAKE_CURRENT_LIST_DIR}/tests/input_test.mjs
                 ${playground_page})
set_tests_properties(playground.times PROPERTIES FIXTURES_REQUIRED "javascript;playground_page" SKIP_RETURN_CODE 77
                                                  TIMEOUT 600 RUN_SERIAL ON)
