# The Python package, in a new virtual environment with its wheel (tests/environment.py). The wheel links the library
# that the build has compiled: kernels of its own take minutes, and are for thorough runs.
set(package_tests ${CMAKE_CURRENT_LIST_DIR}/tests)
set(package_environment ${PROJECT_BINARY_DIR}/python-tests)
set(environment Python3::Interpreter -B ${package_tests}/environment.py)
add_test(NAME python.wheel COMMAND ${environment} make ${package_environment} $<TARGET_FILE:hashnoise-grid>)
set_tests_properties(python.wheel PROPERTIES FIXTURES_SETUP python_wheel FIXTURES_REQUIRED vectors SKIP_RETURN_CODE 77
                     TIMEOUT 3600)
# As users have it, with kernels of its own for all instruction sets. tools/pack python holds it to its vectors.
add_test(NAME python.wheel_of_users CONFIGURATIONS Thorough COMMAND ${environment} make ${package_environment}-of-users)
set_tests_properties(python.wheel_of_users PROPERTIES SKIP_RETURN_CODE 77 RESOURCE_LOCK python_objects COST 400
                     TIMEOUT 3600)

# package_test(NAME MODULE... [WITH FILE] [THOROUGH] [PROPERTIES ...])
# runs modules of tests in the environment, and packages that a file names, which are kept beside it.
function(package_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test THOROUGH WITH PROPERTIES)
  set(when)
  set(with)
  if(test_THOROUGH)
    set(when CONFIGURATIONS Thorough)
  endif()
  if(test_WITH)
    set(with --with ${test_WITH})
  endif()
  add_test(NAME python.${name} ${when} COMMAND ${environment} run ${with} ${package_environment} ${test_UNPARSED_ARGUMENTS})
  set_tests_properties(python.${name} PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77 ${test_PROPERTIES})
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/bake.cmake OPTIONAL)
foreach(subject arrays documents golden odd options source)
  package_test(${subject} ${subject}_test)
endforeach()
# Jupyter and matplotlib take longer to install than all else that the tests need.
package_test(notebook notebook_test WITH notebook.txt THOROUGH PROPERTIES RUN_SERIAL ON)
# Dask is kept beside the environment, since it takes longer to install than its test.
package_test(dask dask_test WITH dask.txt)
# Workers that are killed, and what takes long to install: distributed, xarray with pandas, and Zarr.
package_test(dask_cluster dask_cluster_test WITH dask_cluster.txt THOROUGH)
# hashnoise.arrays: NumPy and JAX, and what takes long to install and to compile, PyTorch.
package_test(libraries libraries_test.Numpy libraries_test.Jax WITH jax.txt PROPERTIES COST 30)
package_test(torch libraries_test.Torch WITH torch.txt THOROUGH)
# PyInstaller and cx_Freeze.
package_test(frozen libraries_test.Frozen WITH frozen.txt THOROUGH)
# The oldest NumPy of the package that this Python has.
package_test(oldest_numpy arrays_test golden_test WITH oldest.txt THOROUGH)
# It installs twine and cibuildwheel.
package_test(registry registry_test WITH registry.txt THOROUGH)
# mypy reads all of NumPy's types, and the stub changes seldom.
package_test(types types_test WITH mypy.txt THOROUGH)
# docs/guide/gpu-computing.md: what runs kernels of OpenCL and CUDA on a CPU, and in a thorough run PyTorch and the others,
# which have gigabytes.
package_test(computing computing_test.Programs WITH jax.txt PROPERTIES COST 30)
package_test(computing_thorough computing_test.Thorough WITH computing_thorough.txt THOROUGH)
add_test(NAME python.environment COMMAND Python3::Interpreter -B -m unittest environment_test
         WORKING_DIRECTORY ${package_tests})
set_tests_properties(python.environment PROPERTIES FIXTURES_REQUIRED python_wheel
                     ENVIRONMENT HASHNOISE_ENVIRONMENT=${package_environment})
