#include "slurm_server.hpp"

#include "tests/kit/free_port.hpp"

#include "benchmark/ab/execution/command.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <thread>

namespace opal::ab_tests {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kPrograms{"/usr/sbin/munged", "/usr/sbin/slurmctld", "/usr/sbin/slurmd",
                                         "/usr/bin/sbatch", "/usr/bin/squeue"};

std::string host() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return std::string(name).substr(0, std::string(name).find('.'));
}

/// Both daemons bind to the address of their node only (NoInAddrAny, NoCtldInAddrAny).
std::string configuration(const std::string& folder) {
  const std::string node = host();
  return "ClusterName=opal\nSlurmctldHost=" + node + "(127.0.0.1)\nSlurmUser=root\nSlurmdUser=root\n" +
         "AuthType=auth/munge\nAuthInfo=socket=" + folder + "/munge.socket\n" +
         "CommunicationParameters=NoInAddrAny,NoCtldInAddrAny\n" + "StateSaveLocation=" + folder +
         "/state\nSlurmdSpoolDir=" + folder + "/spool\n" + "SlurmctldPidFile=" + folder +
         "/slurmctld.pid\nSlurmdPidFile=" + folder + "/slurmd.pid\n" + "SlurmctldPort=" + std::to_string(free_port()) +
         "\nSlurmdPort=" + std::to_string(free_port()) + "\n" +
         "ProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nJobAcctGatherType=jobacct_gather/none\n" +
         "SelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\nSwitchType=switch/none\nMpiDefault=none\n" +
         "ReturnToService=2\nSchedulerParameters=sched_interval=1,sched_min_interval=100000,batch_sched_delay=0\n" +
         "MailProg=/bin/true\nNodeName=" + node + " NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\n" +
         "PartitionName=opal Nodes=" + node + " Default=YES MaxTime=INFINITE State=UP\n";
}

std::string random_key() {
  std::random_device random;
  std::string key(128, '\0');
  for (char& byte : key) byte = static_cast<char>(random());
  return key;
}

}  // namespace

std::string SlurmServer::why_not() {
  if (geteuid() != 0) return "Slurm runs jobs for others, which root only may do";
  for (const std::string& program : kPrograms)
    if (!fs::exists(program)) return program + " is not installed (Debian: slurmctld, slurmd, slurm-client, munge)";
  return "";
}

SlurmServer::SlurmServer() {
  chmod(folder_.path().c_str(), 0755);
  for (const char* name : {"state", "spool"}) fs::create_directory(folder_.path_of(name));
  const std::string key = folder_.write("munge.key", random_key());
  chmod(key.c_str(), 0600);
  setenv("SLURM_CONF", folder_.write("slurm.conf", configuration(folder_.path())).c_str(), 1);
  run({"/usr/sbin/munged", "--foreground", "--force", "--key-file=" + key,
       "--socket=" + folder_.path_of("munge.socket"), "--pid-file=" + folder_.path_of("munged.pid"),
       "--log-file=" + folder_.path_of("munged.log"), "--seed-file=" + folder_.path_of("munged.seed")});
  for (int k = 0; k < 600 && !fs::exists(folder_.path_of("munge.socket")); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  run({"/usr/sbin/slurmctld", "-D", "-i"});
  run({"/usr/sbin/slurmd", "-D"});
  wait_until_ready();
}

void SlurmServer::run(const std::vector<std::string>& words) {
  programs_.push_back(std::make_unique<ab::ChildProcess>([&](const ab::ChildProcess::Say&) {
    const int log = open(folder_.path_of(fs::path(words.front()).filename().string() + ".out").c_str(),
                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execv(arguments.front(), arguments.data());
    _exit(127);
  }));
}

void SlurmServer::wait_until_ready() const {
  constexpr int kTries = 300;
  for (int k = 0; k < kTries; ++k) {
    if (ab::run_command({"sinfo", "--noheader", "--format=%T"}).output == "idle\n") return;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  throw std::runtime_error("Slurm does not come up; see the logs in " + folder_.path());
}

}  // namespace opal::ab_tests
