#include "benchmark/ab/records/result_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "common/text_file.hpp"
#include "common/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::ab {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Where two documents differ first.
struct Difference {
  std::string pointer;
  json before, now;
};

std::optional<Difference> difference(const json& before, const json& now, const std::string& pointer) {
  if (before == now) return std::nullopt;
  const bool same_shape = before.type() == now.type() && before.is_structured() && before.size() == now.size();
  if (!same_shape) return Difference{pointer, before, now};
  if (before.is_array()) {
    for (std::size_t k = 0; k < before.size(); ++k)
      if (auto found = difference(before[k], now[k], pointer + "/" + std::to_string(k))) return found;
    return std::nullopt;
  }
  for (const auto& [key, value] : before.items())
    if (auto found = difference(value, now.value(key, json()), pointer + "/" + escape_pointer_step(key))) return found;
  return Difference{pointer, before, now};  // other keys
}

std::string excerpt(const json& value) {
  constexpr std::size_t kLongest = 80;
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

}  // namespace

ResultFolder::ResultFolder(const std::string& path, const nlohmann::ordered_json& manifest) : path_(path) {
  for (const char* folder : {"journals", "logs"}) make_folder((fs::path(path) / folder).string());
  const std::string name = file("manifest.json");
  if (!fs::exists(name)) write_text(name, manifest.dump(1) + "\n");
  const auto found = difference(read_json(name), json::parse(manifest.dump()), "");
  if (!found) return;
  throw ConfigError(name + ": " + found->pointer + ": was " + excerpt(found->before) +
                    " for the results in this folder and is " + excerpt(found->now) +
                    " now; give another folder, or make it as it was");
}

std::vector<std::string> ResultFolder::journals() const {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(fs::path(path_) / "journals"))
    if (entry.path().extension() == ".jsonl") all.push_back(entry.path().string());
  std::sort(all.begin(), all.end());
  return all;
}

std::string ResultFolder::journal(const Shard& shard, std::size_t worker) const {
  return file(fmt::format("journals/{}.{}.jsonl", shard.name(), worker));
}
std::string ResultFolder::log(const Shard& shard, std::size_t worker) const {
  return file(fmt::format("logs/{}.{}.log", shard.name(), worker));
}

std::vector<bool> finished_cells(const ResultFolder& folder, const CellPlan& plan) {
  std::vector<bool> finished(plan.cells(), false);
  for (const std::string& journal : folder.journals())
    read_journal(journal, [&](const CellResult& result, JournalPlace) {
      if (result.number >= finished.size())
        throw Error(fmt::format("{}: holds cell {}, which the experiment does not have", journal, result.number));
      finished[result.number] = true;
    });
  return finished;
}

}  // namespace opal::ab
