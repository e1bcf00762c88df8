# Draws with the examples and with the command, and fails when the drawings differ.
function(compare a b)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${FOLDER}/${a} ${FOLDER}/${b} RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "${a} and ${b} in ${FOLDER} differ")
  endif()
endfunction()

execute_process(COMMAND ${DRAW_MESH} ${MODEL} ${FOLDER}/mesh_by_library.svg COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${LIGNE} draw ${MODEL} --light 1,2,-3 --hatch shade --hatch-angle face
                        -o ${FOLDER}/mesh_by_command.svg COMMAND_ERROR_IS_FATAL ANY)
compare(mesh_by_library.svg mesh_by_command.svg)

execute_process(COMMAND ${DRAW_SURFACE} "sin(r)/r" ${FOLDER}/surface_by_library.pdf COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${LIGNE} surface "sin(r)/r" -x -8:8:50 -y -8:8:50 --axes --title "sin(r)/r"
                        -o ${FOLDER}/surface_by_command.pdf COMMAND_ERROR_IS_FATAL ANY)
compare(surface_by_library.pdf surface_by_command.pdf)

# As many lines as the JSON drawing has strokes.
execute_process(COMMAND ${LIST_STROKES} ${MODEL} OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${LIGNE} draw ${MODEL} -o ${FOLDER}/strokes.json COMMAND_ERROR_IS_FATAL ANY)
file(READ ${FOLDER}/strokes.json drawing)
string(JSON count LENGTH "${drawing}" strokes)
string(REGEX MATCHALL "\n" lines "${listed}")
list(LENGTH lines line_count)
if(NOT line_count EQUAL count)
  message(FATAL_ERROR "list_strokes gives ${line_count} strokes, the drawing has ${count}")
endif()
