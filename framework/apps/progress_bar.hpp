#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

/// A bar on a terminal, nothing elsewhere.
class ProgressBar {
 public:
  void show(double share) {
    const int percent = static_cast<int>(100 * share);
    if (!terminal_ || percent == shown_) return;
    shown_ = percent;
    std::fprintf(stderr, "\r[%-50.*s] %3d %%", 50, bar(percent).c_str(), percent);
  }
  ~ProgressBar() {
    if (terminal_ && shown_ >= 0) std::fputc('\n', stderr);
  }

 private:
  static std::string bar(int percent) { return std::string(std::clamp(percent / 2, 0, 50), '#'); }
  const bool terminal_ = isatty(STDERR_FILENO) != 0;
  int shown_ = -1;
};
