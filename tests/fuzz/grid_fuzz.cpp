// libFuzzer entry point: whatever a yaml file and its image hold, importing them gives a map or an opal::Error. Input: the
// yaml text, a zero byte, the bytes of the image; the yaml calls the image "i".
#include <opal/error.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace {

std::shared_ptr<const opal::MapImporter> importer() {
  opal::PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/grid_importer.so");
  return registry.make<opal::MapImporter>("opal:GridImporter");
}

/// A folder of its own for each process, so that several may fuzz at a time.
class Folder {
 public:
  Folder() : path_((std::filesystem::temp_directory_path() / "opal_grid_fuzz_XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) std::abort();
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string write(const char* name, std::string_view bytes) const {
    const std::string file = path_ + "/" + name;
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
  }

 private:
  std::string path_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::shared_ptr<const opal::MapImporter> kImporter = importer();
  static const Folder kFolder;
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
