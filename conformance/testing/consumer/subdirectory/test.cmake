# Builds, runs and installs a project that has hashnoise as a part of its build: the headers of hashnoise are installed
# with it only where it includes them.
#   cmake -DSOURCE=<source folder of hashnoise> -DWORK=<scratch folder> -DGENERATOR=<CMake's generator> -P test.cmake
cmake_minimum_required(VERSION 3.21)
function(call)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The installed files below the prefix, of the program and of hashnoise.
function(installed result prefix)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G ${GENERATOR}
                          -DHASHNOISE_SOURCE=${SOURCE} ${ARGN} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  # It links the headers alone, and is not frightened with the minutes of kernels.
  if(NOT said MATCHES "hashnoise::grid, if you link it, has kernels for " OR said MATCHES "minute")
    message(FATAL_ERROR "one line should name the kernels: ${said}")
  endif()
  call(${CMAKE_COMMAND} --build ${WORK}/build --target consumer)
  call(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${prefix})
  file(GLOB_RECURSE files RELATIVE ${prefix} ${prefix}/*)
  set(${result} ${files} PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
installed(files ${WORK}/without)
if(NOT files STREQUAL "bin/consumer")
  message(FATAL_ERROR "only bin/consumer should be installed: ${files}")
endif()
call(${WORK}/without/bin/consumer)

installed(files ${WORK}/with -DHASHNOISE_INSTALL=ON)
foreach(file bin/consumer include/hashnoise/hashnoise.hpp include/hashnoise/glsl.hpp
             include/hashnoise/hashnoise.glsl include/hashnoise/detail/cell.glsl
             share/doc/hashnoise/LICENSE)  # and not in the folder of the project
  if(NOT file IN_LIST files)
    message(FATAL_ERROR "HASHNOISE_INSTALL should install ${file}: ${files}")
  endif()
endforeach()
