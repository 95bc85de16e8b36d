# The heights of one land in all that people work with, from the files that other tests make.
module_test(heights.everywhere ship.heights.heights_test ${PROJECT_BINARY_DIR}/python-tests ${PROJECT_BINARY_DIR}/javascript
            ALONE THOROUGH PROPERTIES FIXTURES_REQUIRED "python_wheel;javascript;npm")
