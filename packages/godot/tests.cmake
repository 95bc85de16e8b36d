# The add-on for Godot: what is in it, and a real Godot that has its values and draws its example. That is the program
# that HN_GODOT names, or the one in the PATH.
set(godot_tests ${CMAKE_CURRENT_LIST_DIR}/tests)
add_test(NAME godot.addon COMMAND Python3::Interpreter -B -m unittest godot_addon.addon_test
         WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/lib)
foreach(subject values example)
  add_test(NAME godot.${subject} COMMAND Python3::Interpreter -B ${godot_tests}/${subject}_test.py)
  set_tests_properties(godot.${subject} PROPERTIES SKIP_RETURN_CODE 77 COST 50)
endforeach()
add_test(NAME godot.engine COMMAND Python3::Interpreter -B -m unittest engine_test WORKING_DIRECTORY ${godot_tests})
