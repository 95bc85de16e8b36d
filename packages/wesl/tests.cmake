# The package for WESL: shaders that import it, linked by npm's wesl and by cargo's, have the values of the library.
# Both in thorough runs alone: npm's wesl and wgpu take seconds, and for cargo's a compilation of it comes first.
set(linked Python3::Interpreter -B -m ship.wesl.linked_test)
add_test(NAME wesl.npm CONFIGURATIONS Thorough COMMAND ${linked} npm ${PROJECT_BINARY_DIR}/javascript
         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/lib)
set_tests_properties(wesl.npm PROPERTIES FIXTURES_REQUIRED javascript)
add_test(NAME wesl.cargo CONFIGURATIONS Thorough COMMAND ${linked} cargo ${PROJECT_BINARY_DIR}/wesl-linker
         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/lib)
set_tests_properties(wesl.npm wesl.cargo PROPERTIES SKIP_RETURN_CODE 77)
