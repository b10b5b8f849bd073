#include "common/whole_file.hpp"

#include "common/write_error.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace opal {
namespace {

namespace fs = std::filesystem;

/// The file that a name stands for: a link is followed, so that it stays a link.
std::string target_of(const std::string& path) {
  std::error_code ignored;
  const fs::path target = fs::canonical(path, ignored);
  return ignored ? path : target.string();
}

/// After this the name of a file is on the disk, and not only its content. Folders that cannot be opened or that their
/// file system does not sync are left to it.
/// @return the cause of a failure, or 0.
int sync_folder_of(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  const int opened = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return errno == EACCES ? 0 : errno;
  const int cause = fsync(opened) == 0 || errno == EINVAL ? 0 : errno;
  close(opened);
  return cause;
}

/// Beside the target, and of this file alone: threads, and processes of other machines, may write it, too.
/// @return the descriptor, or -1 with errno.
int open_draft(const std::string& target, std::string& draft) {
  constexpr int kMostTries = 1000;
  static std::atomic<unsigned> number = 0;
  int file = -1, tries = 0;
  do {
    draft = target + "." + std::to_string(getpid()) + "-" + std::to_string(number++) + ".part";
    file = open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (file < 0 && errno == EEXIST && ++tries < kMostTries);
  return file;
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : path_(path), target_(target_of(path)) {
  struct stat found {};
  const bool exists = stat(target_.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) throw WriteError(path_, EISDIR);
  const bool is_ordinary = !exists || S_ISREG(found.st_mode);
  file_ = is_ordinary ? open_draft(target_, draft_) : open(target_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  if (file_ < 0) {
    const int cause = errno;
    draft_.clear();
    fail(cause);
  }
  constexpr mode_t kPermissions = 07777;
  if (is_ordinary && exists && fchmod(file_, found.st_mode & kPermissions) != 0) fail(errno);
}

WholeFile::~WholeFile() { close_file(); }

void WholeFile::close_file() {
  if (file_ >= 0) close(file_);
  file_ = -1;
  if (!draft_.empty()) unlink(draft_.c_str());
  draft_.clear();
}

void WholeFile::fail(int cause) {
  close_file();
  throw WriteError(path_, cause);
}

void WholeFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void WholeFile::finish() {
  if (!draft_.empty() && fsync(file_) != 0 && errno != EINVAL) fail(errno);
  const int closed = close(file_);
  file_ = -1;
  if (closed != 0) fail(errno);
  if (draft_.empty()) return;
  if (std::rename(draft_.c_str(), target_.c_str()) != 0) fail(errno);
  draft_.clear();
  if (const int cause = sync_folder_of(target_)) fail(cause);
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && !fs::is_directory(path, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw WriteError(path + ": the folder cannot be made: " + cause_text(error.value()));
}

}  // namespace opal
