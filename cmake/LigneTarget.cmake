# One library target per folder. A folder's headers are reached as "NAME/file.hpp" through an include directory that holds
# this folder alone, so a file can include another folder only when its target links that folder's target: an include
# that the architecture forbids does not compile.

add_library(ligne_flags INTERFACE)
# No flag here changes a value: errno and floating-point traps are never looked at.
target_compile_options(ligne_flags INTERFACE -Wall -Wextra -ffp-contract=off -fno-math-errno -fno-trapping-math)
# GCC 12 to 14 see copies that overlap or leave their bounds in "literal" + std::string and in copies of vectors where there are none
# (GCC bug 105651 and others).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15)
  target_compile_options(ligne_flags INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow)
endif()
# Functions of a shared library call each other directly, as in a program.
target_compile_options(ligne_flags INTERFACE -fno-semantic-interposition)
# ccache sees through a precompiled header where the compiler keeps what it replaces.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(ligne_flags INTERFACE -fpch-preprocess)
endif()
if(LIGNE_WERROR)
  target_compile_options(ligne_flags INTERFACE -Werror)
endif()
if(LIGNE_SANITIZE)
  target_compile_options(ligne_flags INTERFACE -fsanitize=${LIGNE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(ligne_flags INTERFACE -fsanitize=${LIGNE_SANITIZE})
endif()

# compile_together(TARGET file... SETS "folder folder ..."...): compiles the sources of a folder together, or of a set of folders ("." is
# that of the target). This spares most of the time that goes into reading headers and into what each source makes of the same
# templates: two seconds a unit. So the names in unnamed namespaces are unique in a folder and in a set. Sources with options of
# their own stay alone. A unit of 4,000 lines takes a dozen seconds; sets keep below 6,000.
function(compile_together target)
  cmake_parse_arguments(ARG "" "" "SETS" ${ARGN})
  foreach(file IN LISTS ARG_UNPARSED_ARGUMENTS)
    get_filename_component(folder ${file} DIRECTORY)
    if(folder STREQUAL "")
      set(folder .)
    endif()
    set(unit ${folder})
    foreach(set IN LISTS ARG_SETS)
      string(REPLACE " " ";" folders ${set})
      if(folder IN_LIST folders)
        list(GET folders 0 unit)
      endif()
    endforeach()
    string(MAKE_C_IDENTIFIER "in_${unit}" unit)
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${unit})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC collects its garbage a tenth of its time where sources are that large; it may keep half a gigabyte first.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=524288 --param=ggc-min-expand=200)
  endif()
endfunction()

# optimize_less(TARGET file... FOLDERS folder...): compiles the sources of these folders, and the units that are made of them, with -O1
# in a release, which takes two thirds of the time of -O3. A unit has the option itself: its sources would leave it with one of their
# own.
function(optimize_less target)
  cmake_parse_arguments(ARG "" "" "FOLDERS" ${ARGN})
  set(cold "")
  set(hot "")
  foreach(file IN LISTS ARG_UNPARSED_ARGUMENTS)
    get_filename_component(folder ${file} DIRECTORY)
    if(folder STREQUAL "")
      set(folder .)
    endif()
    if(LIGNE_UNITY)
      get_source_file_property(unit ${file} UNITY_GROUP)
      set(file ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/Unity/unity_${unit}_cxx.cxx)
    endif()
    if(folder IN_LIST ARG_FOLDERS)
      list(APPEND cold ${file})
    else()
      list(APPEND hot ${file})
    endif()
  endforeach()
  foreach(file IN LISTS cold)
    if(file IN_LIST hot)
      message(FATAL_ERROR "${file} has sources of cold folders and of others")
    endif()
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "$<$<CONFIG:Release>:-O1>")
  endforeach()
endfunction()

# ligne_library(NAME SOURCES file... TOGETHER "folder folder ..."... COLD folder... LINKS target... PRIVATE_LINKS target...): TOGETHER
# names the sets of folders that are compiled together. COLD names the folders in which a drawing spends a few hundredths of its
# instructions at most: they are compiled with -O1. A set is cold as a whole or not at all.
function(ligne_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;TOGETHER;COLD;LINKS;PRIVATE_LINKS" ${ARGN})
  set(gate ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${gate})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${gate}/${name} SYMBOLIC)
  add_library(ligne_${name} STATIC ${ARG_SOURCES})
  # The same objects serve the program, the Python module and a shared library.
  set_target_properties(ligne_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(ligne_${name} REUSE_FROM ligne_headers)
  if(LIGNE_UNITY)
    compile_together(ligne_${name} ${ARG_SOURCES} SETS ${ARG_TOGETHER})
  endif()
  optimize_less(ligne_${name} ${ARG_SOURCES} FOLDERS ${ARG_COLD})
  # Two threads that count at once may lose a count, but never make it none.
  if(LIGNE_COVERAGE)
    target_compile_options(ligne_${name} PRIVATE --coverage)
    target_link_options(ligne_${name} INTERFACE --coverage)
  endif()
  target_include_directories(ligne_${name} PUBLIC ${gate})
  target_link_libraries(ligne_${name} PUBLIC ${ARG_LINKS} PRIVATE ligne_flags ${ARG_PRIVATE_LINKS})
endfunction()
