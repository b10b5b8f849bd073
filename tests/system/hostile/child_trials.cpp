#include "child_trials.hpp"

#include "tests/kit/sanitized.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>

#include <poll.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace {

constexpr int kProcessor_s = 10;
constexpr int kWait_ms = 120'000;  // for a child that sleeps, on a machine that is busy
constexpr rlim_t kAddressSpace = rlim_t{3} << 30;

using Read = std::function<std::string(const std::string&, const std::string&)>;

/// Sanitizers reserve terabytes of addresses, and use few of them.
void limit_memory() {
  if (kIsSanitized) return;
  const rlimit limit{kAddressSpace, kAddressSpace};
  setrlimit(RLIMIT_AS, &limit);
}

void limit_time() {
  const itimerval timer{{0, 0}, {kProcessor_s, 0}};
  setitimer(ITIMER_PROF, &timer, nullptr);  // SIGPROF ends the process
}

/// One letter and a message.
std::string try_to_read(const std::string& path, const std::string& text, const Read& read) {
  std::ofstream(path, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
  limit_time();
  try {
    const std::string complaint = read(path, text);
    return complaint.empty() ? "a" : "f" + complaint;
  } catch (const opal::MapError& error) {
    const bool is_named = std::string(error.what()).find(path) != std::string::npos;
    return (is_named ? "r" : "fthe error does not name the file: ") + std::string(error.what());
  } catch (const std::exception& error) {
    return "fan error of another kind: " + std::string(error.what());
  }
}

void send(int pipe, std::string answer) {
  answer.resize(std::min<std::size_t>(answer.size(), 4000));
  for (char& c : answer)
    if (c == '\0') c = '?';
  answer += '\0';
  if (::write(pipe, answer.data(), answer.size()) != static_cast<ssize_t>(answer.size())) _exit(3);
}

/// Up to the next zero byte; nothing if the child is gone or does not answer.
bool receive(int pipe, std::string& answer) {
  answer.clear();
  for (;;) {
    pollfd waiting{pipe, POLLIN, 0};
    char c = 0;
    if (poll(&waiting, 1, kWait_ms) != 1 || ::read(pipe, &c, 1) != 1) return false;
    if (c == '\0') return true;
    answer += c;
  }
}

std::string death(int status) {
  if (!WIFSIGNALED(status)) return "the process ended by itself with " + std::to_string(WEXITSTATUS(status));
  if (WTERMSIG(status) == SIGPROF) return "more than 10 s of processor time";
  return "the process died by signal " + std::to_string(WTERMSIG(status));
}

Trial trial_of(const std::string& answer) {
  const Trial::Result result = answer[0] == 'a'   ? Trial::Result::accepted
                               : answer[0] == 'r' ? Trial::Result::refused
                                                  : Trial::Result::failed;
  return {result, answer.substr(1)};
}

/// Reads texts from `first` on in a child until it has read all or died. @return the first that was not read.
std::size_t run_child(std::size_t first, const std::string& path, const std::vector<std::string>& texts,
                      const Read& read, std::vector<Trial>& trials) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    limit_memory();
    for (std::size_t k = first; k < texts.size(); ++k) send(ends[1], try_to_read(path, texts[k], read));
    _exit(0);
  }
  close(ends[1]);
  std::string answer;
  std::size_t next = first;
  while (next < texts.size() && receive(ends[0], answer)) trials[next++] = trial_of(answer);
  close(ends[0]);
  if (next < texts.size()) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (next < texts.size()) trials[next++] = {Trial::Result::failed, death(status)};
  return next;
}

}  // namespace

std::vector<Trial> read_in_children(const std::string& file_name, const std::vector<std::string>& texts,
                                    const Read& read) {
  const opal::TemporaryFolder folder;
  std::vector<Trial> trials(texts.size());
  for (std::size_t next = 0; next < texts.size();)
    next = run_child(next, folder.path_of(file_name), texts, read, trials);
  return trials;
}
