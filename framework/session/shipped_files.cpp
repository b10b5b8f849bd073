#include "session/shipped_files.hpp"

#include "common/phrases.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/plugin/plugin_folders.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace opal::session {
namespace {

namespace fs = std::filesystem;

/// Beside them are documents of other kinds, such as trees of behaviours.
bool is_deployment(const fs::path& file) {
  return file.extension() == ".jsonld" && opal::read_json(file.string()).value("@type", "") == "opal:Deployment";
}

std::string shipped_configs() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(shipped_file("configs")))
    if (is_deployment(entry.path())) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return opal::listed(names);
}

}  // namespace

std::string shipped_file(const std::string& name) {
  const fs::path program = fs::canonical("/proc/self/exe").parent_path();
  const fs::path plugins = opal::own_plugin_folder();  // where another program, as Python, has loaded the library
  // What is installed goes first: from /usr/bin, the tree of the sources would be the root folder of the machine.
  for (const fs::path& folder : {program / "../share/opal", plugins / "../../../share/opal",
                                 plugins / "../../../../share/opal", program / "../../..", plugins / "../../.."})
    if (const fs::path file = folder / name; fs::exists(file)) return fs::canonical(file).string();
  throw opal::ConfigError(name + ": is neither beside the sources nor installed");
}

std::string shipped_config(const std::string& name) { return shipped_file("configs/" + name); }

std::string config_file(const std::string& name) {
  if (fs::exists(name) && !fs::is_directory(name)) return name;
  if (fs::is_directory(name) && name.find('/') != std::string::npos)
    throw opal::ConfigError(name + ": is a folder, expected a JSON file");
  if (name.find('/') == std::string::npos)
    for (const std::string& ending : {std::string(), std::string(".jsonld")}) {
      const fs::path file = fs::path(shipped_file("configs")) / (name + ending);
      if (fs::is_regular_file(file)) return file.string();
    }
  throw opal::ConfigError(name + ": does not exist, and is none of the configurations that ship: " + shipped_configs());
}

}  // namespace opal::session
