# The drop-in for glsl-noise in a project with glslify, and with drei, which Vite builds and Chromium draws. It installs
# those, in a folder below that of the packages of other tests.
add_test(NAME glsl_noise.project CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B -m ship.glsl_noise.project_test ${PROJECT_BINARY_DIR}/javascript
         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/lib)
set_tests_properties(glsl_noise.project PROPERTIES FIXTURES_REQUIRED javascript SKIP_RETURN_CODE 77)
