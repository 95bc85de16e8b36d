# The Rust crate: cargo builds what tools/pack makes, and holds it to the vectors. By default some modules of it are
# made; all of them take minutes to write.
module_test(rust.crate ship.rust.cargo_test ALONE PROPERTIES FIXTURES_REQUIRED vectors)
