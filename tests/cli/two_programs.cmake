# A project with the two programs as scripts that say their names.
cmake_minimum_required(VERSION 3.25)
project(two NONE)
foreach(name ligne ligne-study)
  file(WRITE ${CMAKE_BINARY_DIR}/${name}.sh "#!/bin/sh\necho ${name} $*\n")
  file(CHMOD ${CMAKE_BINARY_DIR}/${name}.sh PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  add_custom_target(${name} ALL COMMAND ${CMAKE_COMMAND} -E make_directory src/cli
                    COMMAND ${CMAKE_COMMAND} -E copy ${name}.sh src/cli/${name})
endforeach()
add_dependencies(ligne-study ligne)
