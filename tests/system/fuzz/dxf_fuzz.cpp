// libFuzzer entry point: any bytes called a drawing give a map or an opal::Error.
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <cstdint>

namespace {

std::shared_ptr<const opal::MapImporter> importer() {
  opal::PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/dxf_importer.so");
  return registry.make<opal::MapImporter>(
      "opal:DxfImporter", {{"unit", "m"}, {"classes", {{"W*", "Wall"}, {"C*", "Column"}, {"D*", "Door"}}}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::shared_ptr<const opal::MapImporter> kImporter = importer();
  static const opal::TemporaryFolder kFolder;
  const std::string path = kFolder.write("p.dxf", {reinterpret_cast<const char*>(data), size});
  kImporter->recognizes(path);
  try {
    kImporter->import(path);
  } catch (const opal::Error&) {
  }
  return 0;
}
