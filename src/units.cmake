# compile_units_as_one(TARGET): a compiler reads six units of a target as one. Most of its time goes into the templates
# of packages (gtest, CLI11, JSON), so a build takes two thirds of the time. While you change a program you may prefer
# -DCMAKE_UNITY_BUILD=OFF. Two units that use a name for different things, each in a namespace without a name, cannot be
# in one: SKIP_UNITY_BUILD_INCLUSION keeps one of them out.
function(compile_units_as_one target)
  if(NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
  endif()
endfunction()
