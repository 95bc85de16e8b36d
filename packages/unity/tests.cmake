# It writes all functions of the package in two languages, which takes longer than to compile them.
module_test(unity.package ship.unity.unity_test THOROUGH PROPERTIES FIXTURES_REQUIRED vectors TIMEOUT 3600)
