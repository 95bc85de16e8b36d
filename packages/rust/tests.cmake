# The Rust crate: cargo builds what tools/pack makes, and holds it to the vectors. By default some modules of it are
# made; all of them take minutes to write.
add_test(NAME rust.crate COMMAND Python3::Interpreter -B -m ship.rust.cargo_test
         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/lib)
set_tests_properties(rust.crate PROPERTIES FIXTURES_REQUIRED vectors SKIP_RETURN_CODE 77)
