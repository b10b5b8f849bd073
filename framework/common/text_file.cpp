#include "common/text_file.hpp"

#include <opal/common/error.hpp>

#include <fstream>

namespace opal {

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  if (!(file << text << std::flush)) throw Error(path + ": cannot be written");
}

}  // namespace opal
