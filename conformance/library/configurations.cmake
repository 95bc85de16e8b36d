# From configurations.inc: a twin for each configuration, compiled with its macros and HN_TWIN, its index, and twins.inc,
# a TWIN(index) for each. Sets `twins` to their objects and `configurations` to the names with the macros, as
# "fnv1+sine HN_HASH=HN_HASH_FNV1 HN_GRADIENT=HN_GRADIENT_SINE".
set(table ${CMAKE_CURRENT_LIST_DIR}/configurations.inc)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
file(READ ${table} rows)
string(REGEX MATCHALL "\nCONFIGURATION\\(\"[^\"]+\", [A-Z0-9_]+, [A-Z]+, [0-9]+, [A-Z]+," rows "${rows}")

set(configurations "")
set(twins_inc "")
set(twins "")
set(index 0)
foreach(row IN LISTS rows)
  string(REGEX MATCH "\"([^\"]+)\", ([A-Z0-9_]+), ([A-Z]+), ([0-9]+), ([A-Z]+)" row "${row}")
  set(name ${CMAKE_MATCH_1})
  set(macros HN_HASH=HN_HASH_${CMAKE_MATCH_2} HN_GRADIENT=HN_GRADIENT_${CMAKE_MATCH_3} HN_PERIOD=${CMAKE_MATCH_4}
             HN_ARITHMETIC=HN_${CMAKE_MATCH_5})
  # What is the default is not said.
  list(REMOVE_ITEM macros HN_HASH=HN_HASH_LATTICE HN_GRADIENT=HN_GRADIENT_OCTAHEDRAL HN_PERIOD=0 HN_ARITHMETIC=HN_FAST)
  list(JOIN macros " " text)
  list(APPEND configurations "${name} ${text}")

  add_library(twin${index} OBJECT twin.cpp)
  target_compile_definitions(twin${index} PRIVATE HN_TWIN=${index} ${macros})
  target_include_directories(twin${index} PRIVATE ${CMAKE_CURRENT_BINARY_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(twin${index} PRIVATE hashnoise::hashnoise)
  # The twin's floats must not depend on the compiler: no a*b+c in one rounding.
  target_compile_options(twin${index} PRIVATE ${warnings} -ffp-contract=off)
  list(APPEND twins $<TARGET_OBJECTS:twin${index}>)
  string(APPEND twins_inc "TWIN(${index})\n")
  math(EXPR index "${index} + 1")
endforeach()
file(CONFIGURE OUTPUT twins.inc CONTENT "${twins_inc}" @ONLY)
