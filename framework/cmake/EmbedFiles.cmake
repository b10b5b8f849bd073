# cmake -DOUTPUT=X.cpp -DHEADER=Y.hpp -DNAMES=a;b -DFILES=A;B -P EmbedFiles.cmake: each file's bytes as a std::string_view.
set(source "// Made by EmbedFiles.cmake.\n#include \"${HEADER}\"\n\nnamespace opal {\n")
foreach(name file IN ZIP_LISTS NAMES FILES)
  file(READ ${file} bytes HEX)
  string(LENGTH "${bytes}" digits)
  math(EXPR length "${digits} / 2")
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
  # Lines of string literals: compilers read them many times faster than lists of numbers.
  string(REGEX REPLACE "((\\\\x..)(\\\\x..)?(\\\\x..)?(\\\\x..)?(\\\\x..)?(\\\\x..)?(\\\\x..)?(\\\\x..)?)" "\"\\1\"\n" bytes "${bytes}")
  string(APPEND source "const std::string_view ${name}(\n${bytes}, ${length});\n")
endforeach()
file(WRITE ${OUTPUT} "${source}}  // namespace opal\n")
