# In thorough runs a real Godot has the values of the add-on, and draws its example and its nodes. It is the program that
# HN_GODOT names, the one in the PATH, or Debian's, which is downloaded.
set(godot_tests ${CMAKE_CURRENT_LIST_DIR}/tests)
add_test(NAME godot.engine COMMAND Python3::Interpreter -B -m unittest engine_test WORKING_DIRECTORY ${godot_tests})
add_test(NAME godot.program CONFIGURATIONS Thorough COMMAND Python3::Interpreter -B ${godot_tests}/engine.py)
set_tests_properties(godot.program PROPERTIES SKIP_RETURN_CODE 77 FIXTURES_SETUP godot)
foreach(subject values example land nodes)
  add_test(NAME godot.${subject} CONFIGURATIONS Thorough
           COMMAND Python3::Interpreter -B ${godot_tests}/${subject}_test.py)
  set_tests_properties(godot.${subject} PROPERTIES SKIP_RETURN_CODE 77 COST 50 FIXTURES_REQUIRED godot)
endforeach()
