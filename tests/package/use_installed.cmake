# Installs the library of BUILD into a folder, builds projects outside with it, by find_package and by pkg-config, and compares what
# they draw with what the command draws.
set(prefix ${FOLDER}/prefix)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/build ${FOLDER}/clash)
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component libligne-dev)
if(SHARED)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component libligne0.2)
endif()
run(${LIGNE} draw ${MODEL} -q -o ${FOLDER}/command.svg)

# Every include of ours says ligne/.
file(GLOB_RECURSE headers ${prefix}/include/ligne/*.hpp)
list(LENGTH headers number)
if(number LESS 50)
  message(FATAL_ERROR "only ${number} headers are installed")
endif()
foreach(header IN LISTS headers)
  file(STRINGS ${header} includes REGEX "^ *# *include *\"")
  foreach(line IN LISTS includes)
    if(NOT line MATCHES "\"(ligne/[^\"]+)\"" OR NOT EXISTS ${prefix}/include/${CMAKE_MATCH_1})
      message(FATAL_ERROR "${header}: ${line}")
    endif()
  endforeach()
endforeach()

# No file of one distribution alone.
file(GLOB_RECURSE files ${prefix}/*)
if("${files}" MATCHES "Debian")
  message(FATAL_ERROR "files of Debian are installed: ${files}")
endif()

set(options -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=-Wall\ -Wextra\ -Werror
            -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/outside_project -B ${FOLDER}/build ${options})
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${FOLDER}/build/draw ${MODEL} ${FOLDER}/find_package.svg)
compare(find_package.svg)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/header_clash -B ${FOLDER}/clash ${options})
run(${CMAKE_COMMAND} --build ${FOLDER}/clash)
run(${FOLDER}/clash/clash ${MODEL} ${FOLDER}/clash.svg)
compare(clash.svg)

# The plain call, without --static, links with a static library too.
set(ENV{PKG_CONFIG_PATH} ${prefix}/${LIBDIR}/pkgconfig)
execute_process(COMMAND pkg-config --cflags --libs ligne OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY
                OUTPUT_STRIP_TRAILING_WHITESPACE)
separate_arguments(flags UNIX_COMMAND "${flags}")
run(${LAUNCHER} ${COMPILER} -std=c++20 -c ${CMAKE_CURRENT_LIST_DIR}/outside_project/draw.cpp -o ${FOLDER}/draw.o ${flags})
run(${COMPILER} ${FOLDER}/draw.o -o ${FOLDER}/draw ${flags} -Wl,-rpath,${prefix}/${LIBDIR})
run(${FOLDER}/draw ${MODEL} ${FOLDER}/pkg_config.svg)
compare(pkg_config.svg)

if(SHARED)
  include(${CMAKE_CURRENT_LIST_DIR}/shared_symbols.cmake)
endif()
