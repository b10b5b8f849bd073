#include "common/prepared/prepared_folder.hpp"

#include "common/whole_file.hpp"
#include "common/write_error.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace opal {
namespace {

namespace fs = std::filesystem;

/// Whatever else is in the folder is not ours.
bool is_prepared(const fs::path& file) {
  constexpr std::array<const char*, 2> kEndings{".tiles", ".patterns"};
  return std::find(kEndings.begin(), kEndings.end(), file.extension()) != kEndings.end();
}

}  // namespace

void PreparedFolder::touch(const fs::path& file) {
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
}

/// Maps change, and nobody asks for the old ones again.
void PreparedFolder::forget_old() const {
  constexpr std::chrono::hours kUnused(24 * 30);
  std::error_code ignored;
  const auto now = fs::file_time_type::clock::now();
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored))
    if (is_prepared(entry.path()) && now - entry.last_write_time(ignored) > kUnused) fs::remove(entry.path(), ignored);
}

std::string PreparedFolder::keep(const std::function<void()>& write) const try {
  make_folder(folder_.string());
  forget_old();
  write();
  return "it cannot be read back";
} catch (const WriteError& error) {
  return error.what();
}

}  // namespace opal
