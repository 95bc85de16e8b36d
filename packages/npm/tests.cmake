# The npm package, installed into a project of Vite (tests/project.py): the twin in Node.js, and pages in Chromium.
set(golden ${PROJECT_SOURCE_DIR}/conformance/expected/golden)
add_test(NAME npm.package COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/tests/project.py
                                  ${PROJECT_BINARY_DIR}/javascript)
set_tests_properties(npm.package PROPERTIES FIXTURES_SETUP npm FIXTURES_REQUIRED javascript SKIP_RETURN_CODE 77)
set(project ${javascript}/npm)  # a program of Node.js runs in it
foreach(subject twin fields bundles browser)
  add_test(NAME npm.${subject} COMMAND ${project} node ${subject}.mjs ${golden})
  list(APPEND npm_tests npm.${subject})
endforeach()
# It draws on the processor what is meant for a GPU.
if(EXISTS ${PROJECT_SOURCE_DIR}/examples/three)
  add_test(NAME npm.three CONFIGURATIONS Thorough
           COMMAND ${project} node three.mjs ${PROJECT_SOURCE_DIR})
  list(APPEND npm_tests npm.three)
endif()
add_test(NAME npm.registry CONFIGURATIONS Thorough
         COMMAND ${javascript} node ${tools}/lib/base/javascript/registry.mjs
                 ${PROJECT_SOURCE_DIR}/docs/develop/publishing.md ${PROJECT_BINARY_DIR}/javascript/npm/node_modules/hashnoise)
# From the last commit of version 0.3.0, whose values are others, and from the last release, by its tag.
set(upgrade ${project} node upgrade.mjs ${PROJECT_SOURCE_DIR})
add_test(NAME npm.upgrade CONFIGURATIONS Thorough COMMAND ${upgrade} 5301c2bbb34dc19427c8e36684e48987c682c24f)
add_test(NAME npm.upgrade_from_release CONFIGURATIONS Thorough COMMAND ${upgrade})
set_tests_properties(npm.upgrade npm.upgrade_from_release PROPERTIES RESOURCE_LOCK hashnoise-before)
list(APPEND npm_tests npm.registry npm.upgrade npm.upgrade_from_release)
add_test(NAME npm.types COMMAND ${project} npx --no-install tsc --project .)
set_tests_properties(${npm_tests} npm.types PROPERTIES FIXTURES_REQUIRED "javascript;npm" SKIP_RETURN_CODE 77)
