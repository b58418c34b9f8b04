# Run by embed_files (embed.cmake): turns FILES into the C++ file OUTPUT, which includes HEADER.
set(CODE "#include \"${HEADER}\"\n\nnamespace cigsim {\n")
foreach(FILE IN LISTS FILES)
  get_filename_component(NAME ${FILE} NAME_WE)
  string(MAKE_C_IDENTIFIER ${NAME} NAME)
  file(READ ${FILE} BYTES HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," BYTES "${BYTES}")
  string(APPEND CODE
    "static constexpr char k_${NAME}[] = {${BYTES}};\n"
    "std::string_view embedded_${NAME}() { return {k_${NAME}, sizeof k_${NAME}}; }\n")
endforeach()
string(APPEND CODE "}  // namespace cigsim\n")
file(WRITE ${OUTPUT} "${CODE}")
