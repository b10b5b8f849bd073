// libFuzzer entry point: any text gives a map or an opal::Error, and a map that was read can be written and read again.
#include <opal/error.hpp>
#include <opal/semantic_map.hpp>

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
  const nlohmann::ordered_json written = map->to_json_ld();
  if (opal::SemanticMap::parse(written.dump(), "fuzz")->to_json_ld() != written) std::abort();
  return 0;
}
