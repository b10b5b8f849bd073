#pragma once

#include <sys/types.h>
#include <string>
#include <vector>

namespace opal::store_tests {

struct Finished {
  int exit_code = -1;  ///< -1: ended by a signal
  std::string said;    ///< stdout and stderr
};

/// `opal` as a process of its own, with the environment of this one.
class Program {
 public:
  explicit Program(const std::vector<std::string>& arguments);
  ~Program();  ///< ends it if it still runs
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void kill_at_once();  ///< SIGKILL
  void interrupt();     ///< SIGINT, as Ctrl-C
  Finished wait();
  /// Waits until it has said that. @return false if it ended without.
  bool says(const std::string& text);

 private:
  bool read_more();
  pid_t process_ = -1;
  int output_ = -1;
  std::string said_;
};

Finished opal_run(const std::vector<std::string>& arguments);

}  // namespace opal::store_tests
