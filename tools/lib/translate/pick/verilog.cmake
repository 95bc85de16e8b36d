# Circuits: a few vectors by Icarus Verilog; all, the example, and a million points of each by Verilator.
module_test(pick.verilog translate.pick.verilog_test ${PROJECT_BINARY_DIR}/vectors ALONE
            PROPERTIES FIXTURES_REQUIRED vectors)
module_test(pick.circuits translate.pick.verilog_test ${PROJECT_BINARY_DIR}/vectors Whole THOROUGH
            PROPERTIES FIXTURES_REQUIRED vectors TIMEOUT 7200)
