# It writes all functions of the plugin.
module_test(unreal.plugin ship.unreal.unreal_test THOROUGH PROPERTIES TIMEOUT 3600)
