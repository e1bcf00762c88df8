# Draws MODEL with the example and with the command, and fails when the drawings differ.
execute_process(COMMAND ${EXAMPLE} ${MODEL} ${FOLDER}/by_library.svg COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${LIGNE} draw ${MODEL} --portrait -o ${FOLDER}/by_command.svg COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${FOLDER}/by_library.svg ${FOLDER}/by_command.svg
                RESULT_VARIABLE differs)
if(differs)
  message(FATAL_ERROR "by_library.svg and by_command.svg in ${FOLDER} differ")
endif()
