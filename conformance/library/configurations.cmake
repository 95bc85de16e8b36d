# Sets `configurations` to the rows of configurations.inc, as
# "fnv1+sine HN_HASH=HN_HASH_FNV1 HN_GRADIENT=HN_GRADIENT_SINE":
# the name, and the macros that differ from the default.
set(table ${CMAKE_CURRENT_LIST_DIR}/configurations.inc)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
file(READ ${table} rows)
string(REGEX MATCHALL "\nCONFIGURATION" all "${rows}")
# The families, in small letters, end what concerns the macros.
string(REGEX MATCHALL "\nCONFIGURATION\\(\"[^\"]+\", [A-Z0-9_]+, [A-Z]+, [A-Z]+,[ \n]+[a-z]" rows "${rows}")
list(LENGTH all count)
list(LENGTH rows read)
if(NOT count EQUAL read)
  message(FATAL_ERROR "${table} has ${count} rows, of which ${read} can be read here: "
                      "a row is CONFIGURATION(\"name\", HASH, "
                      "GRADIENT, ARITHMETIC, families), with all but the families on its first line")
endif()

set(configurations "")
foreach(row IN LISTS rows)
  string(REGEX MATCH "\"([^\"]+)\", ([A-Z0-9_]+), ([A-Z]+), ([A-Z]+)" row "${row}")
  set(name ${CMAKE_MATCH_1})
  set(macros HN_HASH=HN_HASH_${CMAKE_MATCH_2} HN_GRADIENT=HN_GRADIENT_${CMAKE_MATCH_3}
             HN_ARITHMETIC=HN_${CMAKE_MATCH_4})
  # What is the default is not said.
  list(REMOVE_ITEM macros HN_HASH=HN_HASH_LATTICE HN_GRADIENT=HN_GRADIENT_OCTAHEDRAL HN_ARITHMETIC=HN_FAST)
  list(JOIN macros " " text)
  list(APPEND configurations "${name} ${text}")
endforeach()
