#include "common/text_file.hpp"

#include "common/whole_file.hpp"

namespace opal {

void write_text(const std::string& path, const std::string& text) {
  WholeFile file(path);
  file.write(text);
  file.finish();
}

}  // namespace opal
