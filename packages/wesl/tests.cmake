# The package for WESL: shaders that import it, linked by npm's wesl and by cargo's, have the values of the library.
# Both in thorough runs alone: npm's wesl and wgpu take seconds, and for cargo's a compilation of it comes first.
module_test(wesl.npm ship.wesl.linked_test npm ${PROJECT_BINARY_DIR}/javascript ALONE THOROUGH
            PROPERTIES FIXTURES_REQUIRED javascript)
module_test(wesl.cargo ship.wesl.linked_test cargo ${PROJECT_BINARY_DIR}/wesl-linker ALONE THOROUGH)
