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

/// Where two documents differ first; null: nothing was, or is, there.
struct Difference {
  std::string pointer;
  json before, now;
};

/// What an item of a list is known by.
json name_or_item(const json& item) { return item.is_object() && item.contains("name") ? item["name"] : item; }

/// The first item of a list that another list has nowhere, with its place; null if there is none.
std::pair<json, std::string> first_alone(const json& list, const json& other, const std::string& pointer) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    const json name = name_or_item(list[k]);
    if (std::none_of(other.begin(), other.end(), [&](const json& item) { return name_or_item(item) == name; }))
      return {name, pointer + "/" + std::to_string(k)};
  }
  return {json(), pointer};
}

std::optional<Difference> difference_of_lists(const json& before, const json& now, const std::string& pointer);
std::optional<Difference> difference(const json& before, const json& now, const std::string& pointer) {
  if (before == now) return std::nullopt;
  if (before.type() != now.type() || !before.is_structured()) return Difference{pointer, before, now};
  if (before.is_array()) return difference_of_lists(before, now, pointer);
  for (const json* keys : {&before, &now})
    for (const auto& [key, ignored] : keys->items())
      if (auto found =
              difference(before.value(key, json()), now.value(key, json()), pointer + "/" + escape_pointer_step(key)))
        return found;
  return std::nullopt;
}

/// Of lists of other lengths: an item that went, or else one that came.
std::optional<Difference> difference_of_lists(const json& before, const json& now, const std::string& pointer) {
  if (before.size() != now.size()) {
    if (const auto [went, place] = first_alone(before, now, pointer); !went.is_null())
      return Difference{place, went, json()};
    const auto [came, place] = first_alone(now, before, pointer);
    return came.is_null() ? Difference{pointer, before, now} : Difference{place, json(), came};
  }
  for (std::size_t k = 0; k < before.size(); ++k)
    if (auto found = difference(before[k], now[k], pointer + "/" + std::to_string(k))) return found;
  return std::nullopt;
}

std::string excerpt(const json& value) {
  if (value.is_null()) return "absent";
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
