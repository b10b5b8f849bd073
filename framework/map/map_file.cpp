#include "map/map_file.hpp"

#include "common/text_file.hpp"

namespace opal {

void write_map(const SemanticMap& map, const std::string& path) { write_text(path, map.to_json_ld().dump(1) + '\n'); }

}  // namespace opal
