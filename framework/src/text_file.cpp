#include <opal/text_file.hpp>

#include <opal/error.hpp>

#include <fstream>

namespace opal {

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  if (!(file << text << std::flush)) throw Error(path + ": cannot be written");
}

void write_map(const SemanticMap& map, const std::string& path) { write_text(path, map.to_json_ld().dump(1) + '\n'); }

}  // namespace opal
