// libFuzzer entry point: any text gives a map or an opal::Error, and a map that was read is written and read again
// whole.
#include <opal/common/error.hpp>
#include <opal/map/semantic_map.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::shared_ptr<const opal::SemanticMap> map;
  try {
    map = opal::SemanticMap::parse(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
  } catch (const opal::Error&) {
    return 0;
  }
  // Blank node labels are given anew at every reading, so ids may differ; nothing may get lost.
  const auto again = opal::SemanticMap::parse(map->to_json_ld().dump(), "fuzz");
  if (again->features().size() != map->features().size() || again->objects().size() != map->objects().size())
    std::abort();
  return 0;
}
