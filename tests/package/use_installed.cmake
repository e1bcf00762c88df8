# Installs the library into a folder, builds the project outside with it twice, and compares what it draws with what the
# command draws.
set(prefix ${FOLDER}/prefix)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/build)
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()
function(compare file)
  run(${CMAKE_COMMAND} -E compare_files ${FOLDER}/${file} ${FOLDER}/command.svg)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component libligne-dev)
run(${LIGNE} draw ${MODEL} -q -o ${FOLDER}/command.svg)

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/outside_project -B ${FOLDER}/build -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=-Wall\ -Wextra\ -Werror)
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${FOLDER}/build/draw ${MODEL} ${FOLDER}/find_package.svg)
compare(find_package.svg)

set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
set(static --static)
if(SHARED)
  set(static "")
endif()
execute_process(COMMAND pkg-config --cflags --libs ${static} ligne OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY
                OUTPUT_STRIP_TRAILING_WHITESPACE)
separate_arguments(flags UNIX_COMMAND "${flags}")
run(${COMPILER} -std=c++20 ${CMAKE_CURRENT_LIST_DIR}/outside_project/draw.cpp -o ${FOLDER}/draw ${flags} -Wl,-rpath,${prefix}/${LIBDIR})
run(${FOLDER}/draw ${MODEL} ${FOLDER}/pkg_config.svg)
compare(pkg_config.svg)
