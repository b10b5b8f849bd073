// libFuzzer entry point: any bytes called GeoJSON, or XML of OpenStreetMap if they begin with "<", give storeys and a
// map, in metres or degrees, or an opal::Error.
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <cstdint>

namespace {

using Importer = std::shared_ptr<const opal::MapImporter>;

Importer importer(bool geographic) {
  opal::PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/geojson_importer.so");
  return registry.make<opal::MapImporter>(
      "opal:GeoJsonImporter", {{"geographic", geographic}, {"classes", {{"a=*", "Wall"}, {"b=*", "Door"}}}});
}

void use(const opal::MapImporter& importer, const std::string& path) {
  try {
    importer.storeys(path);
    importer.import(path);
  } catch (const opal::Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Importer kFlat = importer(false), kGeographic = importer(true);
  static const opal::TemporaryFolder kFolder;
  const std::string path =
      kFolder.write(size > 0 && data[0] == '<' ? "p.osm" : "p.json", {reinterpret_cast<const char*>(data), size});
  kFlat->recognizes(path);
  use(*kFlat, path);
  use(*kGeographic, path);
  return 0;
}
