# hn-base, for whoever needs it first: a program of src/ or the suite.
include(${CMAKE_CURRENT_LIST_DIR}/units.cmake)
if(NOT TARGET hn-base)
  add_subdirectory(${CMAKE_CURRENT_LIST_DIR}/base ${PROJECT_BINARY_DIR}/src/base)
endif()
