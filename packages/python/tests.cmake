# The Python package, in a new virtual environment with its wheel (tests/environment.py). The wheel links the library
# that the build has compiled: kernels of its own take minutes, and are for thorough runs.
set(package_tests ${CMAKE_CURRENT_LIST_DIR}/tests)
set(package_environment ${PROJECT_BINARY_DIR}/python-tests)
add_test(NAME python.wheel
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py make ${package_environment}
                 $<TARGET_FILE:hashnoise-grid>)
set_tests_properties(python.wheel PROPERTIES FIXTURES_SETUP python_wheel FIXTURES_REQUIRED vectors SKIP_RETURN_CODE 77
                     TIMEOUT 3600)
# As users have it, with kernels of its own for all instruction sets. tools/pack python holds it to golden values.
add_test(NAME python.wheel_of_users CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py make ${package_environment}-of-users)
set_tests_properties(python.wheel_of_users PROPERTIES SKIP_RETURN_CODE 77 COST 400 TIMEOUT 3600)
# Jupyter and matplotlib take longer to install than all else that the tests need.
add_test(NAME python.notebook CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with notebook.txt ${package_environment}
                 notebook_test)
set_tests_properties(python.notebook PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77 RUN_SERIAL ON)
include(${CMAKE_CURRENT_LIST_DIR}/bake.cmake OPTIONAL)
# Dask is kept beside the environment, since it takes longer to install than its test.
add_test(NAME python.dask COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with dask.txt
                                  ${package_environment} dask_test)
# hashnoise.arrays: NumPy and JAX, and what takes long to install and to compile, PyTorch.
add_test(NAME python.libraries COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with jax.txt
                                       ${package_environment} libraries_test.Numpy libraries_test.Jax)
add_test(NAME python.torch CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with torch.txt
                 ${package_environment} libraries_test.Torch)
set_tests_properties(python.libraries python.torch PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77 COST 30)
# Workers that are killed, and what takes long to install: distributed, xarray with pandas, and Zarr.
add_test(NAME python.dask_cluster CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with dask_cluster.txt
                 ${package_environment} dask_cluster_test)
set_tests_properties(python.dask python.dask_cluster PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77)
# The oldest NumPy of the package that this Python has.
add_test(NAME python.oldest_numpy CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with oldest.txt
                 ${package_environment} arrays_test golden_test)
set_tests_properties(python.oldest_numpy PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77)
# It builds a wheel once more.
add_test(NAME python.manylinux CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run ${package_environment} manylinux_test)
set_tests_properties(python.manylinux PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77
                     ENVIRONMENT HASHNOISE_LIBRARY=$<TARGET_FILE:hashnoise-grid>)
# It installs twine.
add_test(NAME python.registry CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with twine.txt ${package_environment} registry_test)
set_tests_properties(python.registry PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77)
# mypy reads all of NumPy's types, and the stub changes seldom.
add_test(NAME python.types CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with mypy.txt ${package_environment} types_test)
set_tests_properties(python.types PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77)
# docs/guide/gpu-computing.md: what runs kernels of OpenCL and CUDA on a CPU, and in a thorough run PyTorch and the others,
# which have gigabytes.
add_test(NAME python.computing COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with jax.txt
                                       ${package_environment} computing_test.Programs)
add_test(NAME python.computing_thorough CONFIGURATIONS Thorough
         COMMAND Python3::Interpreter -B ${package_tests}/environment.py run --with computing_thorough.txt
                 ${package_environment} computing_test.Thorough)
set_tests_properties(python.computing python.computing_thorough PROPERTIES FIXTURES_REQUIRED python_wheel
                     SKIP_RETURN_CODE 77 COST 30)
foreach(subject arrays documents golden odd options source)
  add_test(NAME python.${subject} COMMAND Python3::Interpreter -B ${package_tests}/environment.py run ${package_environment} ${subject}_test)
  set_tests_properties(python.${subject} PROPERTIES FIXTURES_REQUIRED python_wheel SKIP_RETURN_CODE 77)
endforeach()
add_test(NAME python.environment COMMAND Python3::Interpreter -B -m unittest environment_test
         WORKING_DIRECTORY ${package_tests})
set_tests_properties(python.environment PROPERTIES FIXTURES_REQUIRED python_wheel
                     ENVIRONMENT HASHNOISE_ENVIRONMENT=${package_environment})
