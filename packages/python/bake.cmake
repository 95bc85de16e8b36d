# Files of noise are read by programs of others: pypng and three.js. Masks of blue noise are measured.
package_test(bake bake_test bluenoise_test WITH bake.txt PROPERTIES FIXTURES_REQUIRED "python_wheel;javascript;playground_page"
             ENVIRONMENT "HASHNOISE_JAVASCRIPT=${PROJECT_BINARY_DIR}/javascript;HASHNOISE_PAGE=${PROJECT_BINARY_DIR}/playground/playground.html")
# The command builds the package for itself.
add_test(NAME bake.command CONFIGURATIONS Thorough
         COMMAND ${PROJECT_SOURCE_DIR}/tools/bake cellular --size 64x64 -o ${PROJECT_BINARY_DIR}/bake.exr)
set_tests_properties(bake.command PROPERTIES RESOURCE_LOCK python_objects TIMEOUT 3600)
