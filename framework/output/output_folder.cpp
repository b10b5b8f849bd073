#include "output/output_folder.hpp"

#include "common/whole_file.hpp"
#include "common/write_error.hpp"

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

namespace opal {
namespace {

namespace fs = std::filesystem;

/// Whether a descriptor is still the file of that name: the program before may have removed it a moment ago.
bool is_file_of(int file, const std::string& name) {
  struct stat open_file {
  }, named{};
  return fstat(file, &open_file) == 0 && stat(name.c_str(), &named) == 0 && open_file.st_ino == named.st_ino &&
         open_file.st_dev == named.st_dev;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& path, const std::string& command, const std::vector<std::string>& products)
    : path_(path), marker_((path / kUnfinishedMarker).string()), run_(this_run(command)) {
  make_folder(path.string());
  lock();
  try {
    mark();
    remove_old(products);
  } catch (...) {
    give_up();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  if (file_ < 0) return;
  run_.ending = "ended with an error";
  try {
    mark();
  } catch (const WriteError&) {  // the disk is full: the mark is there, and says less
  }
  release();
}

void OutputFolder::finish() {
  if (unlink(marker_.c_str()) != 0) throw WriteError(marker_, errno);
  release();
}

void OutputFolder::interrupt(int signal) {
  run_.ending = "was interrupted (" + signal_name(signal) + ")";
  mark();
  release();
}

void OutputFolder::lock() {
  // Whoever reads a marker holds its lock for a moment.
  constexpr int kTries = 10;
  constexpr std::chrono::milliseconds kPause(20);
  for (int k = 0; k < kTries; ++k) {
    if (try_lock()) return;
    std::this_thread::sleep_for(kPause);
  }
  const auto other = unfinished_run(path_.string());
  throw FolderInUse(path_.string() + ": " + (other ? other->who() : "another program") +
                    " writes into this folder; wait for its end, or give another folder");
}

bool OutputFolder::try_lock() {
  file_ = open(marker_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw WriteError(marker_, errno);
  const bool is_locked = flock(file_, LOCK_EX | LOCK_NB) == 0;
  const int cause = errno;
  if (is_locked && is_file_of(file_, marker_)) return true;
  release();
  if (!is_locked && cause != EWOULDBLOCK) throw WriteError(marker_ + ": cannot be locked: " + cause_text(cause));
  return false;
}

void OutputFolder::mark() const {
  const std::string text = text_of(run_);
  const ssize_t count = pwrite(file_, text.data(), text.size(), 0);
  if (count != static_cast<ssize_t>(text.size())) throw WriteError(marker_, count < 0 ? errno : ENOSPC);
  if (ftruncate(file_, count) != 0 || (fsync(file_) != 0 && errno != EINVAL)) throw WriteError(marker_, errno);
}

void OutputFolder::remove_old(const std::vector<std::string>& products) const {
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    const auto is_named = [&](const std::string& product) { return fnmatch(product.c_str(), name.c_str(), 0) == 0; };
    if (entry.is_directory() || std::none_of(products.begin(), products.end(), is_named)) continue;
    if (unlink(entry.path().c_str()) != 0 && errno != ENOENT) throw WriteError(entry.path().string(), errno);
  }
}

void OutputFolder::release() {
  if (file_ >= 0) close(file_);
  file_ = -1;
}

/// A marker that could not be written says nothing: it does not stay.
void OutputFolder::give_up() {
  struct stat found {};
  if (fstat(file_, &found) == 0 && found.st_size == 0) unlink(marker_.c_str());
  release();
}

std::string signal_name(int signal) {
  if (signal == SIGINT) return "SIGINT";
  if (signal == SIGTERM) return "SIGTERM";
  return "signal " + std::to_string(signal);
}

}  // namespace opal
