# It installs the add-on into Blender, of a package of 374 MB, and Cycles renders each node group.
module_test(blender.addon ship.blender.blender_test ${PROJECT_BINARY_DIR}/python-tests THOROUGH
            PROPERTIES FIXTURES_REQUIRED python_wheel)
