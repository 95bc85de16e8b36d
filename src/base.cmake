# The programs of src/ stand on the first room of conformance/, base: errors, files, signals. Where the suite is not
# built, this makes that room alone.
if(NOT HASHNOISE_CONFORMANCE AND NOT TARGET hn-base)
  add_subdirectory(${PROJECT_SOURCE_DIR}/conformance ${PROJECT_BINARY_DIR}/conformance)
endif()
