# Run by embed_files (embed.cmake): turns FILES, below BASE, into the C++ file OUTPUT with the
# function embedded_NAME.
set(TEXTS "")
set(TABLE "")
foreach(FILE IN LISTS FILES)
  string(MAKE_C_IDENTIFIER ${FILE} TEXT)
  file(READ ${BASE}/${FILE} BYTES HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," BYTES "${BYTES}")
  # A byte more, so that an empty file is an array too.
  string(APPEND TEXTS "constexpr char k_${TEXT}[] = {${BYTES}0};\n")
  string(APPEND TABLE "    {\"${FILE}\", {k_${TEXT}, sizeof k_${TEXT} - 1}},\n")
endforeach()
file(WRITE ${OUTPUT}
  "#include \"common/embedded_file.hpp\"\n\nnamespace cigsim {\nnamespace {\n${TEXTS}"
  "constexpr EmbeddedFile kFiles[] = {\n${TABLE}};\n}  // namespace\n"
  "std::span<const EmbeddedFile> embedded_${NAME}() { return kFiles; }\n}  // namespace cigsim\n")
