#include "benchmark/ab/execution/command.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace opal::ab {
namespace {

struct Pipe {
  int from = -1, to = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Error("a pipe cannot be made: " + std::string(std::strerror(errno)));
    from = ends[0];
    to = ends[1];
  }
  ~Pipe() {
    close(from);
    close_to();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_to() {
    if (to >= 0) close(to);
    to = -1;
  }
};

/// @return whether there may be more.
bool read_some(const pollfd& waiting, std::string& text) {
  if (waiting.revents == 0) return true;
  std::array<char, 4096> block{};
  const ssize_t size = read(waiting.fd, block.data(), block.size());
  if (size > 0) text.append(block.data(), static_cast<std::size_t>(size));
  return size > 0;
}

void read_both(int output, int errors, CommandResult& result) {
  std::array<pollfd, 2> waiting{{{output, POLLIN, 0}, {errors, POLLIN, 0}}};
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    if (poll(waiting.data(), waiting.size(), -1) < 0) continue;
    if (waiting[0].fd >= 0 && !read_some(waiting[0], result.output)) waiting[0].fd = -1;
    if (waiting[1].fd >= 0 && !read_some(waiting[1], result.errors)) waiting[1].fd = -1;
  }
}

}  // namespace

CommandResult run_command(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  Pipe output, errors;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output.to, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.to, STDERR_FILENO);
  pid_t process = -1;
  const int error = posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return {127, "", words.front() + ": there is no such program\n"};
  if (error != 0) throw Error(words.front() + ": cannot be run: " + std::strerror(error));
  output.close_to();
  errors.close_to();
  CommandResult result;
  read_both(output.from, errors.from, result);
  int status = 0;
  waitpid(process, &status, 0);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

std::string output_of(const std::vector<std::string>& words) {
  const CommandResult result = run_command(words);
  if (result.exit_code == 0) return result.output;
  throw Error(fmt::format("{}: exit code {}: {}", fmt::join(words, " "), result.exit_code, result.errors));
}

}  // namespace opal::ab
