#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

/// A folder of its own for each process, so that several may fuzz at a time.
class SourceFolder {
 public:
  explicit SourceFolder(const std::string& name)
      : path_((std::filesystem::temp_directory_path() / (name + "_XXXXXX")).string()) {
    if (mkdtemp(path_.data()) == nullptr) std::abort();
  }
  ~SourceFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  SourceFolder(const SourceFolder&) = delete;
  SourceFolder& operator=(const SourceFolder&) = delete;

  std::string write(const char* name, std::string_view bytes) const {
    const std::string file = path_ + "/" + name;
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
  }

 private:
  std::string path_;
};
