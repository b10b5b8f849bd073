#include "program.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace opal::store_tests {

Program::Program(const std::vector<std::string>& arguments) {
  const char* file = std::getenv("OPAL_PROGRAM");
  if (file == nullptr) throw std::runtime_error("OPAL_PROGRAM does not name the program");
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
  process_ = fork();
  if (process_ == 0) {
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    std::vector<char*> argv{const_cast<char*>("opal")};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(file, argv.data());
    _exit(127);
  }
  close(ends[1]);
  output_ = ends[0];
}

Program::~Program() {
  if (process_ > 0) {
    kill_at_once();
    waitpid(process_, nullptr, 0);
  }
  close(output_);
}

void Program::kill_at_once() { kill(process_, SIGKILL); }
void Program::interrupt() { kill(process_, SIGINT); }

bool Program::read_more() {
  char block[4096];
  const ssize_t size = ::read(output_, block, sizeof block);
  if (size > 0) said_.append(block, static_cast<std::size_t>(size));
  return size > 0;
}

bool Program::says(const std::string& text) {
  while (said_.find(text) == std::string::npos)
    if (!read_more()) return false;
  return true;
}

Finished Program::wait() {
  while (read_more()) continue;
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said_};
}

Finished opal_run(const std::vector<std::string>& arguments) { return Program(arguments).wait(); }

}  // namespace opal::store_tests
