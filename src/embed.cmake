# cmake -DFOLDER=<where texts.txt lies> -DHEADER=<from src/> -DOUTPUT=<file.cpp> -P embed.cmake
# Writes the files that texts.txt lists, each behind its constant's name, as the string_views that the header declares;
# files of one constant follow each other. As single characters, since a compiler need not take a string literal of
# more than 65,536 bytes.
file(STRINGS ${FOLDER}/texts.txt lines)

foreach(line IN LISTS lines)
  string(REPLACE " " ";" line ${line})
  list(GET line 0 constant)
  list(GET line 1 name)
  file(READ ${FOLDER}/${name} bytes HEX)
  string(APPEND ${constant} ${bytes})
  list(APPEND constants ${constant})
endforeach()
list(REMOVE_DUPLICATES constants)

set(text "#include \"${HEADER}\"\n\nnamespace manifuzz {\n")
foreach(constant IN LISTS constants)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," characters "${${constant}}")
  string(REGEX REPLACE "('.x0a',)" "\\1\n" characters "${characters}")
  string(APPEND text "
namespace {
constexpr char ${constant}Bytes[] = {
${characters}};
}  // namespace
const std::string_view ${constant}(${constant}Bytes, sizeof ${constant}Bytes);
")
endforeach()
string(APPEND text "\n}  // namespace manifuzz\n")
file(WRITE ${OUTPUT} "${text}")
