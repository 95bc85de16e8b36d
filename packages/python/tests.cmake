# The Python package, in a new virtual environment with its wheel (tests/environment.py). The wheel compiles the library
# for every instruction set and takes minutes, so what needs it is for thorough runs.
set(package_tests ${CMAKE_CURRENT_LIST_DIR}/tests)
set(package_environment ${PROJECT_BINARY_DIR}/python-tests)
add_test(NAME python.wheel CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py make ${package_environment})
set_tests_properties(python.wheel PROPERTIES FIXTURES_SETUP python_wheel SKIP_RETURN_CODE 77 COST 200 TIMEOUT 3600)
foreach(subject arrays documents golden notebook options source types)
  add_test(NAME python.${subject} CONFIGURATIONS Thorough
           COMMAND Python3::Interpreter -B ${package_tests}/environment.py run ${package_environment} ${subject}_test)
  set_tests_properties(python.${subject} PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77)
endforeach()
add_test(NAME python.environment COMMAND Python3::Interpreter -B -m unittest environment_test
         WORKING_DIRECTORY ${package_tests})
