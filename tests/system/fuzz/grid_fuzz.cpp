// libFuzzer entry point: whatever a yaml file and its image hold, importing them gives a map or an opal::Error. Input:
// the yaml text, a zero byte, the bytes of the image; the yaml calls the image "i".
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <cstdint>
#include <string_view>

namespace {

std::shared_ptr<const opal::MapImporter> importer() {
  opal::PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/grid_importer.so");
  return registry.make<opal::MapImporter>("opal:GridImporter");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::shared_ptr<const opal::MapImporter> kImporter = importer();
  static const opal::TemporaryFolder kFolder;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = std::min(bytes.find('\0'), size);
  kFolder.write("i", bytes.substr(std::min(zero + 1, size)));
  const std::string yaml = kFolder.write("m.yaml", bytes.substr(0, zero));
  kImporter->recognizes(yaml);
  try {
    kImporter->import(yaml);
  } catch (const opal::Error&) {
  }
  return 0;
}
