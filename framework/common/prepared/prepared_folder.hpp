#pragma once

#include <opal/common/export.hpp>
#include <opal/common/warning.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace opal {

/// Files of what is computed of large maps, one for each map and purpose. Their names say of what they are made, so
/// that another map, or a program that computes in another way, has other files. Two programs may make the same at
/// once.
class OPAL_EXPORT PreparedFolder {
 public:
  /// @param folder  made when needed; empty: nothing is kept.
  explicit PreparedFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  bool keeps() const { return !folder_.empty(); }

  /// As a file has it; else it is made and written first. What cannot be kept is as it was made, and a warning says so.
  /// @param read   what is in a file; nothing if there is no such file, or it is damaged.
  /// @param write  throws WriteError.
  template <class T, class Read, class Make, class Write>
  T kept(const std::string& name, const Read& read, const Make& make, const Write& write) const {
    const std::filesystem::path file = folder_ / name;
    if (std::optional<T> found = read(file)) {
      touch(file);
      return std::move(*found);
    }
    T made = make();
    const std::string complaint = keep([&] { write(file, made); });
    if (std::optional<T> found = read(file)) return std::move(*found);
    warn("the prepared map is not kept: " + complaint);
    return made;
  }

 private:
  static void touch(const std::filesystem::path& file);
  void forget_old() const;
  /// @return why nothing is kept, if nothing is: another program may have kept the same meanwhile.
  std::string keep(const std::function<void()>& write) const;

  std::filesystem::path folder_;
};

}  // namespace opal
