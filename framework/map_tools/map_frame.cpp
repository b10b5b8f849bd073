#include "map_tools/map_frame.hpp"

#include "map/map_vocabulary.hpp"

#include <cstddef>

namespace opal {
namespace {

/// "frame#/@type: ..." is about the frame, everything else about the map.
[[noreturn]] void rethrow(const json_ld::JsonLdError& error, const NamedDocument& map, const NamedDocument& frame) {
  const std::string start = "frame";
  if (error.pointer().rfind(start, 0) != 0) throw MapError(map.name + ": " + error.what());
  const std::string rest = std::string(error.what()).substr(start.size());
  throw MapError(frame.name + ": " + (rest[0] == '#' ? rest.substr(1) : "(root)" + rest));
}

}  // namespace

nlohmann::json framed_map(const NamedDocument& map, const NamedDocument& frame, const json_ld::FrameOptions& options) {
  json_ld::Options strict;
  strict.contexts[vocabulary::kContextIri] = vocabulary::context_document();
  strict.reject_unknown_terms = true;
  try {
    return json_ld::frame(map.content, frame.content, strict, options);
  } catch (const json_ld::JsonLdError& error) {
    rethrow(error, map, frame);
  }
}

std::size_t matches_in(const nlohmann::json& framed) {
  const auto graph = framed.find("@graph");
  if (graph != framed.end() && graph->is_array()) return graph->size();
  const std::size_t context = framed.contains("@context") ? 1 : 0;
  return framed.size() > context ? 1 : 0;
}

}  // namespace opal
