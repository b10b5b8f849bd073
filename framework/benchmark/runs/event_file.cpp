#include "benchmark/runs/event_file.hpp"

#include "common/write_error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace opal::benchmark {

EventFile::EventFile(const std::string& path)
    : path_(path), file_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw opal::WriteError(path, errno);
}

EventFile::~EventFile() {
  try {
    flush();
  } catch (const opal::WriteError&) {  // it was said when the file was written, or the program ends by another error
  }
  close(file_);
}

void EventFile::write(const nlohmann::ordered_json& event) {
  constexpr std::streamoff kBlock = 1 << 16;
  sink_.write(event);
  if (lines_.tellp() >= kBlock) flush();
}

void EventFile::flush() {
  const std::string lines = std::move(lines_).str();
  lines_ = std::ostringstream();
  std::size_t done = 0;
  while (done < lines.size()) {
    const ssize_t count = ::write(file_, lines.data() + done, lines.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int cause = errno;
      const std::size_t end = done == 0 ? std::string::npos : lines.rfind('\n', done - 1);
      written_ += end == std::string::npos ? 0 : static_cast<long>(end) + 1;
      const bool is_cut = ftruncate(file_, written_) == 0;
      throw opal::WriteError(path_, is_cut ? cause : errno);
    }
    done += static_cast<std::size_t>(count);
  }
  written_ += static_cast<long>(lines.size());
}

void EventFile::finish() {
  flush();
  if (fsync(file_) != 0 && errno != EINVAL) throw opal::WriteError(path_, errno);
}

}  // namespace opal::benchmark
