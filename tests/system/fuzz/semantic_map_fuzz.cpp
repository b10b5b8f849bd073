// libFuzzer entry point: any text gives a map or an opal::Error, and a map that was read is written and read again
// whole. What the reader of plain documents makes of a text, the general reader makes of it too.
#include <opal/common/error.hpp>
#include <opal/map/semantic_map.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

/// The map, or what is wrong with it.
std::string outcome(const std::string& text) {
  try {
    return opal::SemanticMap::parse(text, "fuzz")->to_json_ld().dump();
  } catch (const opal::Error& error) {
    return error.what();
  }
}

/// The same document in words that need the general reader; empty if there is no such.
std::string for_general_reader(const std::string& text) {
  nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
  if (!document.is_object() || !document.contains("@context")) return "";
  nlohmann::json& context = document["@context"];
  if (!context.is_array()) context = nlohmann::json::array({context});
  context.insert(context.begin(), nullptr);
  return document.dump();
}

/// Labels of blank nodes that Opal makes no use of may differ.
void compare_readers(const std::string& text, const opal::SemanticMap& map) {
  if (map.unused().dump().find("\"_:") != std::string::npos) return;
  const std::string general = for_general_reader(text);
  if (!general.empty() && outcome(general) != map.to_json_ld().dump()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::shared_ptr<const opal::SemanticMap> map;
  try {
    map = opal::SemanticMap::parse(text, "fuzz");
  } catch (const opal::Error&) {
    return 0;
  }
  compare_readers(text, *map);
  // Blank node labels are given anew at every reading, so ids may differ; nothing may get lost.
  const auto again = opal::SemanticMap::parse(map->to_json_ld().dump(), "fuzz");
  if (again->features().size() != map->features().size() || again->objects().size() != map->objects().size())
    std::abort();
  return 0;
}
