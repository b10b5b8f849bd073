#include "benchmark/ab/records/program_files.hpp"

#include "common/digest/sha256.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/plugin_folders.hpp>

#include <dlfcn.h>

#include <filesystem>
#include <map>

namespace opal::ab {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string library_file() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&own_plugin_folder), &info) == 0)
    throw Error("libopal.so: the file that this program uses cannot be found");
  return info.dli_fname;
}

}  // namespace

ordered_json program_files() {
  return {{"version", OPAL_VERSION},
          {"program_sha256", sha256_of_file("/proc/self/exe")},
          {"library_sha256", sha256_of_file(library_file())}};
}

ordered_json plugin_files(const PluginRegistry& registry) {
  std::map<std::string, RegisteredType> plugins;
  for (const RegisteredType& type : registry.types()) plugins.emplace(type.plugin, type);
  auto files = ordered_json::array();
  for (const auto& [name, type] : plugins) {
    files.push_back({{"name", name}, {"version", type.version}, {"sha256", sha256_of_file(type.file)}});
    const std::string description = fs::path(type.file).replace_extension(".jsonld").string();
    if (fs::exists(description)) files.back()["description_sha256"] = sha256_of_file(description);  // else: a link
  }
  return files;
}

}  // namespace opal::ab
