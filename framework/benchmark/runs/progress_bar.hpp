#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace opal::benchmark {

/// A bar on a terminal, nothing elsewhere.
class ProgressBar {
 public:
  /// @param note  stands behind the bar.
  void show(double share, const std::string& note = "") {
    const int percent = static_cast<int>(100 * share);
    if (!terminal_ || (percent == shown_ && note == note_)) return;
    shown_ = percent;
    note_ = note;
    std::fprintf(stderr, "\r[%-50.*s] %3d %% %s\033[K", 50, bar(percent).c_str(), percent, note.c_str());
  }
  /// Makes room for a line of text.
  void clear() {
    if (terminal_ && shown_ >= 0) std::fprintf(stderr, "\r\033[K");
    shown_ = -1;
  }
  ~ProgressBar() {
    if (terminal_ && shown_ >= 0) std::fputc('\n', stderr);
  }

 private:
  static std::string bar(int percent) { return std::string(std::clamp(percent / 2, 0, 50), '#'); }
  const bool terminal_ = isatty(STDERR_FILENO) != 0;
  int shown_ = -1;
  std::string note_;
};

}  // namespace opal::benchmark
