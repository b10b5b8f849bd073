#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace opal {

/// A folder of its own, by its canonical path, gone with this. Tests run at the same time, so nothing that they write
/// may have a fixed path.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_((std::filesystem::canonical(std::filesystem::temp_directory_path()) / "opal_test_XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error(path_ + ": cannot make a temporary folder");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string path_of(const std::string& name) const { return path_ + "/" + name; }
  /// @return the path of the new file.
  std::string write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path_of(name), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path_of(name);
  }

 private:
  std::string path_;
};

/// A file with a name and a content, in a folder that goes away with this.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, std::string_view bytes) : path_(folder_.write(name, bytes)) {}
  const std::string& path() const { return path_; }

 private:
  TemporaryFolder folder_;
  std::string path_;
};

}  // namespace opal
