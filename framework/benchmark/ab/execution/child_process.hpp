#pragma once

#include <sys/types.h>
#include <functional>
#include <string>

namespace opal::ab {

/// Work in a process of its own: what crashes, hangs or eats memory there does so there. It ends with this object, and
/// with the process that made it at the latest.
class ChildProcess {
 public:
  using Say = std::function<void(const std::string& line)>;  ///< tells the parent; without ends of lines
  /// @param work  may throw; the message arrives as what the end was.
  explicit ChildProcess(const std::function<void(const Say&)>& work);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  enum class Heard { line, nothing, end };
  /// Waits up to `patience_s` for the next line.
  Heard hear(std::string& line, double patience_s);

  /// After its end: "" if it came to its end, "crashed: signal 11 (SIGSEGV)", "threw: ...", "ended by itself with 3".
  const std::string& failure() const { return failure_; }
  double peak_mb() const { return peak_mb_; }  ///< after its end
  double memory_mb() const;                    ///< now
  /// At once. What it has said and nobody heard is lost.
  void end();

 private:
  void take_ending();
  bool take_line(std::string& line);

  pid_t process_ = -1;
  int pipe_ = -1;
  std::string said_, threw_, failure_;
  double peak_mb_ = 0;
};

/// The child's next line; if there is none, why: its failure, "hung: ..." or "out of memory: ...", after which it is
/// gone.
struct Answer {
  bool given = false;
  std::string line, failure;
};
Answer next_answer(ChildProcess& child, double wall_s, double memory_mb);

}  // namespace opal::ab
