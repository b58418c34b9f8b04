# Files that a library carries inside it.
#
# embed_files(OUTPUT file.cpp NAME name BASE folder FILES …): at build time turns the files, whose
# paths are relative to BASE, into the C++ file OUTPUT of the current binary folder. It defines
#   std::span<const EmbeddedFile> embedded_name()      of namespace cigsim
# (common/embedded_file.hpp), in the order of FILES and with those paths. A header of the library
# declares it.
function(embed_files)
  cmake_parse_arguments(ARG "" "OUTPUT;NAME;BASE" "FILES" ${ARGN})
  list(TRANSFORM ARG_FILES PREPEND ${ARG_BASE}/ OUTPUT_VARIABLE SOURCES)
  foreach(FILE IN LISTS SOURCES)
    if(NOT EXISTS ${FILE})
      message(FATAL_ERROR "${FILE} is missing; the program carries it")
    endif()
  endforeach()
  set(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake)
  set(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${ARG_OUTPUT})
  add_custom_command(OUTPUT ${OUTPUT}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${OUTPUT} -D NAME=${ARG_NAME} -D BASE=${ARG_BASE}
            -D "FILES=${ARG_FILES}" -P ${SCRIPT}
    DEPENDS ${SOURCES} ${SCRIPT}
    COMMENT "Embedding the files of ${ARG_OUTPUT}" VERBATIM)
endfunction()
