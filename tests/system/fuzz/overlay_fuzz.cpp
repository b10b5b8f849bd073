// Whatever the bytes, an overlay is laid over a map or refused with an opal::Error; laid over the result, it changes
// nothing.
#include <opal/common/error.hpp>
#include "map/overlay/map_overlay.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto room = opal::SemanticMap::read(OPAL_SOURCE_DIR "/maps/example_room.jsonld");
  std::vector<opal::MapOverlay> overlays;
  std::shared_ptr<const opal::SemanticMap> once;
  try {
    overlays.push_back(opal::parse_overlay(std::string(reinterpret_cast<const char*>(data), size), "fuzz"));
    once = opal::overlaid_map(*room, overlays).map;
  } catch (const opal::Error&) {
    return 0;
  }
  const auto twice = opal::overlaid_map(*once, overlays).map;
  if (twice->to_json_ld() != once->to_json_ld()) std::abort();
  return 0;
}
