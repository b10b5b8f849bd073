#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace opal_test {

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::string bad_plugin(const std::string& name) {
  return std::filesystem::canonical(OPAL_BAD_PLUGIN_DIR).string() + "/" + name;
}

/// A folder of its own for one test, gone afterwards.
class PluginFolder {
 public:
  PluginFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "opal_plugins_XXXXXX").string();
    path_ = std::filesystem::canonical(mkdtemp(pattern.data()));
  }
  ~PluginFolder() { std::filesystem::remove_all(path_); }
  PluginFolder(const PluginFolder&) = delete;
  PluginFolder& operator=(const PluginFolder&) = delete;

  std::string path() const { return path_.string(); }

  /// @return the path of the new file.
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return (path_ / name).string();
  }
  std::string copy(const std::string& source) const {
    const auto target = path_ / std::filesystem::path(source).filename();
    std::filesystem::copy_file(source, target);
    return target.string();
  }

 private:
  std::filesystem::path path_;
};

}  // namespace opal_test
