#include "benchmark/ab/execution/claim.hpp"

#include "common/write_error.hpp"
#include "output/output_folder.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace opal::ab {
namespace {

struct flock range(short kind, std::size_t first, std::size_t end) {
  struct flock lock {};
  lock.l_type = kind;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(first);
  lock.l_len = static_cast<off_t>(end - first);
  return lock;
}

}  // namespace

Claim::Claim(const std::string& folder, std::size_t first, std::size_t end)
    : folder_(folder), first_(first), end_(end) {
  const std::string path = folder + "/claims";
  file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw WriteError(path, errno);
  if (first == end) return;
  // Workers of a run that was killed a moment ago may still be on their way out.
  constexpr int kTries = 100;
  constexpr std::chrono::milliseconds kPause(20);
  for (int k = 0; !lock(F_WRLCK); ++k) {
    if (k == kTries)
      throw FolderInUse(folder_ + ": " + holder() +
                        " computes these cells already; wait for its end, or give another folder");
    std::this_thread::sleep_for(kPause);
  }
  lock(F_RDLCK);  // shared with the workers, which lock for themselves: a lock is a process's own
}

Claim::~Claim() { close(file_); }

void Claim::join() {
  if (first_ < end_ && !lock(F_RDLCK)) throw FolderInUse(folder_ + ": " + holder() + " computes these cells by now");
}

bool Claim::lock(short kind) const {
  struct flock wanted = range(kind, first_, end_);
  return fcntl(file_, F_SETLK, &wanted) == 0;
}

std::string Claim::holder() const {
  struct flock found = range(F_WRLCK, first_, end_);
  if (fcntl(file_, F_GETLK, &found) != 0 || found.l_type == F_UNLCK || found.l_pid <= 0) return "another process";
  return fmt::format("process {}", found.l_pid);
}

}  // namespace opal::ab
