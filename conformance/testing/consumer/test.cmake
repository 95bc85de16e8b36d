# Installs hashnoise into a fresh prefix, then builds and runs a project that finds it there.
#   cmake -DBUILD=<build folder> -DWORK=<scratch folder> -DGENERATOR=<CMake's generator> -DGRID=<whether the build has
#         hashnoise::grid> -P test.cmake
function(call)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
file(REMOVE_RECURSE ${WORK})
call(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
call(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${WORK}/prefix)
call(${CMAKE_COMMAND} --build ${WORK}/build)
call(${WORK}/build/consumer)
if(GRID)
  call(${WORK}/build/grid)
endif()
