# It makes all nodes, and shaders of them by PyPI's MaterialX; Blender's Cycles runs those in OSL, of a package of 374
# MB.
module_test(materialx.library ship.materialx.materialx_test THOROUGH
            PROPERTIES FIXTURES_REQUIRED vectors ENVIRONMENT GALLIVM_PERF=nopt)
