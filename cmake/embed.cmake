# Files that a library carries inside it.
#
# embed_files(OUTPUT file.cpp HEADER header.hpp FILES …): at build time turns the files into the C++
# file OUTPUT of the current binary folder. HEADER, which OUTPUT includes, declares its functions: a
# file NAME-OF-IT.ending is read through `std::string_view embedded_name_of_it()` of namespace
# cigsim.
function(embed_files)
  cmake_parse_arguments(ARG "" "OUTPUT;HEADER" "FILES" ${ARGN})
  foreach(FILE IN LISTS ARG_FILES)
    if(NOT EXISTS ${FILE})
      message(FATAL_ERROR "${FILE} is missing; the program carries it")
    endif()
  endforeach()
  set(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake)
  set(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${ARG_OUTPUT})
  add_custom_command(OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${OUTPUT} -D HEADER=${ARG_HEADER} -D "FILES=${ARG_FILES}"
            -P ${SCRIPT}
    DEPENDS ${ARG_FILES} ${SCRIPT}
    COMMENT "Embedding the files of ${ARG_OUTPUT}" VERBATIM)
endfunction()
