# cmake -DFOLDER=<where files.txt lies> -DOUTPUT=<file.cpp> -P embed.cmake
# Writes the files that files.txt lists as the string_views that page.cpp declares: as single characters, since a
# compiler need not take a string literal of more than 65,536 bytes.
file(STRINGS ${FOLDER}/files.txt files)

set(html "")
set(css "")
set(js "")
foreach(name IN LISTS files)
  string(REGEX MATCH "[a-z]+$" kind ${name})
  file(READ ${FOLDER}/${name} bytes HEX)
  string(APPEND ${kind} ${bytes})
endforeach()

# embed(<constant> <hexadecimal digits>): appends the constant's definition to `text`.
function(embed constant hex)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," characters "${hex}")
  string(REGEX REPLACE "('.x0a',)" "\\1\n" characters "${characters}")
  set(text "${text}
namespace {
constexpr char ${constant}Bytes[] = {
${characters}};
}  // namespace
extern const std::string_view ${constant};
const std::string_view ${constant}(${constant}Bytes, sizeof ${constant}Bytes);
" PARENT_SCOPE)
endfunction()

set(text "#include <string_view>\n\nnamespace manifuzz {\n")
embed(kPageTemplate "${html}")
embed(kPageStyle "${css}")
embed(kPageScript "${js}")
string(APPEND text "\n}  // namespace manifuzz\n")
file(WRITE ${OUTPUT} "${text}")
