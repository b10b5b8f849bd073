#include "trial.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <csignal>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace opal::ifc_importer {
namespace {

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  (void)setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

[[noreturn]] void run_child(const std::function<void()>& act, unsigned cpu_s) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, cpu_s);
  try {
    act();
  } catch (...) {  // the caller will meet the same, and name it
  }
  _exit(0);
}

int status_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

void try_in_child(const std::function<void()>& act, const std::string& name, unsigned cpu_s) {
  const pid_t child = fork();
  if (child == 0) run_child(act, cpu_s);
  if (child < 0) return;  // no process to be had: then without a trial
  const int status = status_of(child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : SIGABRT;  // a sanitizer ends a process by itself
  if (signal == SIGXCPU || signal == SIGKILL)
    throw MapError(fmt::format("{}: takes more than {} s or more memory than there is to read, expected a whole model",
                               name, cpu_s));
  throw MapError(fmt::format("{}: brings the reader of IFC down (signal {}): the file is damaged", name, signal));
}

}  // namespace opal::ifc_importer
