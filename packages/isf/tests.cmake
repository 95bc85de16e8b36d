# It draws all looks.
module_test(isf.looks ship.isf.isf_test ${PROJECT_BINARY_DIR}/isf-tests THOROUGH PROPERTIES ENVIRONMENT GALLIVM_PERF=nopt)
