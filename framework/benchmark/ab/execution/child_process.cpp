#include "benchmark/ab/execution/child_process.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>

namespace opal::ab {
namespace {

// What a child writes: a letter, the text, an end of line.
constexpr char kLine = '.', kThrew = '!';

void write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);  // nobody is there any more
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void say(int file, char kind, std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  write_all(file, kind + text + '\n');
}

/// How the parent reports its own crashes is not for its child. Ctrl-C and Slurm's scancel reach both at once: the
/// parent ends, and its child with it, and is not taken for one that died by itself.
void set_signals() {
  for (const int number : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) signal(number, SIG_DFL);
  for (const int number : {SIGHUP, SIGINT, SIGTERM}) signal(number, SIG_IGN);
}

[[noreturn]] void work_and_exit(const std::function<void(const ChildProcess::Say&)>& work, int pipe) {
  try {
    work([pipe](const std::string& line) { say(pipe, kLine, line); });
  } catch (const std::exception& error) {
    say(pipe, kThrew, error.what());
  } catch (...) {
    say(pipe, kThrew, "something that is no std::exception");
  }
  _exit(0);  // not through what the parent wanted done at its own end
}

std::string crash(int signal) {
  const char* name = sigabbrev_np(signal);
  return fmt::format("crashed: signal {}{}", signal, name ? " (SIG" + std::string(name) + ")" : "");
}

}  // namespace

ChildProcess::ChildProcess(const std::function<void(const Say&)>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error("a pipe cannot be made: " + std::string(std::strerror(errno)));
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) {
    close(ends[0]);
    close(ends[1]);
    throw Error("a process cannot be started: " + std::string(std::strerror(errno)));
  }
  if (process_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    close(ends[0]);
    set_signals();
    work_and_exit(work, ends[1]);
  }
  close(ends[1]);
  pipe_ = ends[0];
}

ChildProcess::~ChildProcess() {
  end();
  close(pipe_);
}

void ChildProcess::end() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  take_ending();
}

void ChildProcess::take_ending() {
  int status = 0;
  rusage usage{};
  while (wait4(process_, &status, 0, &usage) < 0 && errno == EINTR) continue;
  process_ = -1;
  peak_mb_ = static_cast<double>(usage.ru_maxrss) / 1024;
  if (!threw_.empty())
    failure_ = "threw: " + threw_;
  else if (WIFSIGNALED(status))
    failure_ = crash(WTERMSIG(status));
  else if (WEXITSTATUS(status) != 0)
    failure_ = fmt::format("ended by itself with {}", WEXITSTATUS(status));
}

bool ChildProcess::take_line(std::string& line) {
  const auto end = said_.find('\n');
  if (end == std::string::npos) return false;
  const bool threw = said_.front() == kThrew;
  (threw ? threw_ : line) = said_.substr(1, end - 1);
  said_.erase(0, end + 1);
  return !threw;
}

ChildProcess::Heard ChildProcess::hear(std::string& line, double patience_s) {
  if (take_line(line)) return Heard::line;
  if (process_ < 0) return Heard::end;
  pollfd waiting{pipe_, POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(1e3 * patience_s)) <= 0) return Heard::nothing;
  char block[4096];
  const ssize_t size = read(pipe_, block, sizeof block);
  if (size > 0) said_.append(block, static_cast<std::size_t>(size));
  if (take_line(line)) return Heard::line;
  if (size != 0) return Heard::nothing;
  take_ending();
  return Heard::end;
}

double ChildProcess::memory_mb() const {
  std::ifstream file(fmt::format("/proc/{}/statm", process_));
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

Answer next_answer(ChildProcess& child, double wall_s, double memory_mb) {
  using Clock = std::chrono::steady_clock;
  constexpr double kWatch_s = 0.05;
  const auto start = Clock::now();
  Answer answer;
  const auto give_up = [&](std::string why) {
    child.end();
    answer.failure = std::move(why);
    return answer;
  };
  for (;;) {
    switch (child.hear(answer.line, kWatch_s)) {
      case ChildProcess::Heard::line: answer.given = true; return answer;
      case ChildProcess::Heard::end: answer.failure = child.failure(); return answer;
      case ChildProcess::Heard::nothing: break;
    }
    if (child.memory_mb() > memory_mb) return give_up(fmt::format("out of memory: over {:g} MB", memory_mb));
    if (std::chrono::duration<double>(Clock::now() - start).count() > wall_s)
      return give_up(fmt::format("hung: over {:g} s", wall_s));
  }
}

}  // namespace opal::ab
