#pragma once

#include <cstddef>
#include <string>

namespace opal::ab {

/// The right to compute tasks [first, end) of the experiment in a folder. It ends with the process, however that ends.
/// Advisory locks on a file (POSIX fcntl), a byte per task; they hold across machines where the file system says so.
class Claim {
 public:
  /// @throws FolderInUse naming the folder and who has it, if any of these tasks is claimed.
  Claim(const std::string& folder, std::size_t first, std::size_t end);
  ~Claim();
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;

  /// In a child process: takes part in the claim of its parent. @throws FolderInUse if the claim is somebody else's.
  void join();

 private:
  bool lock(short kind) const;
  std::string holder() const;

  std::string folder_;
  std::size_t first_, end_;
  int file_ = -1;
};

}  // namespace opal::ab
