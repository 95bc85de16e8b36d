# The tests of measuring that are no modules' alone.

# They time a noise with the library that is here, or one that is compiled then.
module_test(bench.grid measure.grid_test ${PROJECT_BINARY_DIR} PROPERTIES RUN_SERIAL ON)
# Each test of the randomness rejects what it should (tools.measure.hashes), and the default hash passes them all.
# (Every hash by command: golden files pin their bits, so that what was judged is what is there.)
add_test(NAME hashes.gate CONFIGURATIONS Thorough COMMAND ${tools}/measure hashes --quick --hash LATTICE)
# Debian's spirv-opt has two published bugs, which the suite finds; a thorough run fetches the other translators.
module_test(translators.debian measure.translators_test $<TARGET_FILE:hn-conform> ALONE
            PROPERTIES ENVIRONMENT GALLIVM_PERF=nopt)
add_test(NAME translators.all CONFIGURATIONS Thorough COMMAND ${tools}/measure translators
         --program $<TARGET_FILE:hn-conform> --out ${PROJECT_BINARY_DIR}/published)
set_tests_properties(translators.all PROPERTIES SKIP_RETURN_CODE 4 TIMEOUT 7200)
