# Turns format.fmt and microprogram.mas of each of STAGES, folders beside this file, into the C++
# file OUTPUT, which defines the function of firmware/embedded.hpp.
set(TEXTS "")
set(TABLE "")
foreach(STAGE IN LISTS STAGES)
  foreach(FILE format.fmt microprogram.mas)
    string(MAKE_C_IDENTIFIER "${STAGE}_${FILE}" NAME)
    file(READ ${CMAKE_CURRENT_LIST_DIR}/${STAGE}/${FILE} BYTES HEX)
    string(REGEX REPLACE "(..)" "'\\\\x\\1'," BYTES "${BYTES}")
    string(APPEND TEXTS "constexpr char k_${NAME}[] = {${BYTES}};\n")
  endforeach()
  string(APPEND TABLE
    "    {\"${STAGE}\", {k_${STAGE}_format_fmt, sizeof k_${STAGE}_format_fmt},\n"
    "     {k_${STAGE}_microprogram_mas, sizeof k_${STAGE}_microprogram_mas}},\n")
endforeach()
file(WRITE ${OUTPUT}
  "#include \"firmware/embedded.hpp\"\n\nnamespace cigsim::firmware {\nnamespace {\n${TEXTS}"
  "constexpr EmbeddedProgram kPrograms[] = {\n${TABLE}};\n}  // namespace\n"
  "std::span<const EmbeddedProgram> embedded_programs() { return kPrograms; }\n"
  "}  // namespace cigsim::firmware\n")
