#include "test_server.hpp"

#include "tests/kit/free_port.hpp"

#include "plugins/postgis_store/server.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <grp.h>
#include <netinet/in.h>
#include <pwd.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace opal::store_tests {
namespace {

namespace fs = std::filesystem;

/// Whom the server runs as; null: as us.
const passwd* server_user() {
  static const passwd* user = geteuid() == 0 ? getpwnam("postgres") : nullptr;
  return user;
}

void wait_for(pid_t child, const std::string& what) {
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) throw std::runtime_error(what + " failed");
}

/// In the child: the server's user, its end when ours comes, its words into a file.
[[noreturn]] void become(const std::vector<std::string>& arguments, const fs::path& log) {
  if (const passwd* user = server_user())
    if (initgroups(user->pw_name, user->pw_gid) != 0 || setgid(user->pw_gid) != 0 || setuid(user->pw_uid) != 0)
      _exit(126);
  prctl(PR_SET_PDEATHSIG, SIGQUIT);
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  if (chdir("/") != 0) _exit(126);
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(argv.front(), argv.data());
  _exit(127);
}

}  // namespace

fs::path TestServer::programs() {
  std::vector<fs::path> found;
  const fs::path root = "/usr/lib/postgresql";
  if (!fs::is_directory(root)) return {};
  for (const fs::directory_entry& version : fs::directory_iterator(root)) {
    const fs::path postgis = "/usr/share/postgresql" / version.path().filename() / "extension/postgis.control";
    if (fs::exists(version.path() / "bin/initdb") && fs::exists(postgis)) found.push_back(version.path() / "bin");
  }
  if (geteuid() == 0 && server_user() == nullptr) return {};
  return found.empty() ? fs::path() : *std::max_element(found.begin(), found.end());
}

TestServer::TestServer(const fs::path& programs) : programs_(programs), port_(free_port()) {
  if (const passwd* user = server_user())
    if (chown(folder().c_str(), user->pw_uid, user->pw_gid) != 0) throw std::runtime_error("chown failed");
  const fs::path password = folder() / "password";
  std::ofstream(password) << kPassword << '\n';
  chmod(password.c_str(), 0644);  // the folder is closed to others
  wait_for(run({(programs_ / "initdb").string(), "-D", (folder() / "data").string(), "-U", kSuperuser, "-E", "UTF8",
                "--locale=C.UTF-8", "-A", "scram-sha-256", "--pwfile", password.string(), "--no-sync"}),
           "initdb");
  setenv("PGHOST", folder().c_str(), 1);
  setenv("PGPORT", std::to_string(port_).c_str(), 1);
  setenv("PGUSER", kSuperuser, 1);
  setenv("PGPASSWORD", kPassword, 1);
  setenv("PGDATABASE", "postgres", 1);
  for (const char* other : {"PGSERVICE", "PGHOSTADDR", "PGSERVICEFILE", "PGPASSFILE", "PGOPTIONS", "PGSSLMODE"})
    unsetenv(other);
  start();
}

TestServer::~TestServer() { stop(); }

pid_t TestServer::run(const std::vector<std::string>& arguments) const {
  const fs::path log = folder() / "log";
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) become(arguments, log);
  return child;
}

void TestServer::start() {
  postgres_ =
      run({(programs_ / "postgres").string(), "-D", (folder() / "data").string(), "-k", folder().string(), "-p",
           std::to_string(port_), "-c", "listen_addresses=127.0.0.1", "-c", "fsync=off", "-c", "max_connections=150"});
  for (int k = 0; k < 600 && !is_ready(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (!is_ready()) throw std::runtime_error("the server does not start; see " + (folder() / "log").string());
}

void TestServer::stop() {
  if (postgres_ <= 0) return;
  kill(postgres_, SIGQUIT);
  waitpid(postgres_, nullptr, 0);
  postgres_ = -1;
}

bool TestServer::is_ready() const {
  try {
    postgis_store::Server({}).read([](postgis_store::Session& session) { session.ask("SELECT 1"); });
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void TestServer::use_new_database(const std::string& name) {
  const std::string command = "PGDATABASE=postgres '" + (programs_ / "createdb").string() + "' '" + name + "'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("createdb failed");
  setenv("PGDATABASE", name.c_str(), 1);
}

}  // namespace opal::store_tests
