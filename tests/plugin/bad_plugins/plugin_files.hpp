#pragma once

#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <filesystem>
#include <string>

namespace opal_test {

inline std::string bad_plugin(const std::string& name) {
  return std::filesystem::canonical(OPAL_BAD_PLUGIN_DIR).string() + "/" + name;
}

class PluginFolder : public opal::TemporaryFolder {
 public:
  /// @return the path of the new file.
  std::string copy(const std::string& source) const {
    const std::string target = path_of(std::filesystem::path(source).filename().string());
    std::filesystem::copy_file(source, target);
    return target;
  }
};

}  // namespace opal_test
