#include "output/unfinished_run.hpp"

#include "common/utc_time.hpp"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

namespace opal {
namespace {

using nlohmann::ordered_json;

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

std::string member(const ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string content_of(int file) {
  constexpr std::size_t kLongest = 4096;  // a marker has some hundred bytes
  std::string text(kLongest, '\0');
  const ssize_t count = pread(file, text.data(), text.size(), 0);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return text;
}

}  // namespace

std::string UnfinishedRun::who() const {
  std::string text = command.empty() ? "a program" : command;
  if (process == 0) return text;
  text += " (process " + std::to_string(process);
  if (!host.empty()) text += " on " + host;
  if (!since.empty()) text += ", since " + since;
  return text + ")";
}

UnfinishedRun parse_unfinished_run(const std::string& text) {
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  UnfinishedRun run{member(json, "command"), 0, member(json, "host"), member(json, "since"), member(json, "ending")};
  if (const auto process = json.find("process"); process != json.end() && process->is_number_integer())
    run.process = process->get<long>();
  return run;
}

std::string text_of(const UnfinishedRun& run) {
  ordered_json json{{"note", "the run that writes into this folder has not finished"},
                    {"command", run.command},
                    {"process", run.process},
                    {"host", run.host},
                    {"since", run.since}};
  if (!run.ending.empty()) json["ending"] = run.ending;
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

UnfinishedRun this_run(const std::string& command) { return {command, getpid(), host_name(), now_utc(), "", true}; }

std::optional<UnfinishedRun> unfinished_run(const std::string& folder) {
  const std::string marker = (std::filesystem::path(folder) / kUnfinishedMarker).string();
  const int file = open(marker.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  UnfinishedRun run = parse_unfinished_run(content_of(file));
  run.is_running = flock(file, LOCK_SH | LOCK_NB) != 0;
  close(file);
  return run;
}

std::string unfinished_note(const std::string& folder) {
  const auto run = unfinished_run(folder);
  if (!run) return "";
  if (run->is_running) return "this run is not finished: " + run->who() + " still writes";
  return "this run was not finished: " + run->who() + " " + (run->ending.empty() ? "was killed" : run->ending);
}

}  // namespace opal
