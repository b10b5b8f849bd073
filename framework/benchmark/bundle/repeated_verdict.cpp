#include "benchmark/bundle/repeated_verdict.hpp"

#include "benchmark/cells/ab_report.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

namespace opal::ab {
namespace {

using nlohmann::json;

/// What no other metric of the experiment has a part in: Holm's correction has.
constexpr std::array kNumbersOfMetric{"baseline", "arm", "difference", "interval", "pairs", "better", "worse", "p"};

std::string then_and_now(const std::string& what, const json& then, const json& now) {
  const auto text = [](const json& value) {
    return value.is_number_float() ? fmt::format("{:.6g}", value.get<double>()) : value.dump();
  };
  return fmt::format("{} was {} and is {}", what, text(then), text(now));
}

std::vector<json> lines_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path + ": cannot be read");
  std::vector<json> lines;
  for (std::string line; std::getline(file, line);)
    lines.push_back(parse_json(line, fmt::format("{}: line {}", path, lines.size() + 1)));
  return lines;
}

/// Names and digests of all files that a manifest tells of; classes by the last part of their path.
std::map<std::string, std::string> parts_of(const json& manifest) {
  const std::string version = manifest.at("/opal/version"_json_pointer).get<std::string>() + ", ";
  std::map<std::string, std::string> parts{
      {"opal", version + manifest["opal"]["program_sha256"].get<std::string>()},
      {"libopal.so", version + manifest["opal"]["library_sha256"].get<std::string>()}};
  for (const json& arm : manifest.at("arms"))
    for (const json& plugin : arm.at("plugins")) {
      const std::string name = std::filesystem::path(plugin.at("name").get<std::string>()).filename().string();
      const std::string part = arm.at("name").get<std::string>() + ": " + name;
      parts[part] = plugin.at("version").get<std::string>() + ", " + plugin.at("sha256").get<std::string>();
      if (plugin.contains("description_sha256"))
        parts[part + ", description"] = plugin["description_sha256"].get<std::string>();
    }
  for (const auto& [scenario, inputs] : manifest.at("inputs").items())
    for (const auto& [name, digest] : inputs.items()) parts[scenario + ": " + name] = digest.get<std::string>();
  return parts;
}

std::vector<std::string> other_parts(const json& then, const json& now) {
  std::vector<std::string> sentences;
  std::map<std::string, std::string> parts = parts_of(now);
  for (const auto& [name, was] : parts_of(then)) {
    const auto found = parts.find(name);
    if (found == parts.end() || found->second != was)
      sentences.push_back(name + " was " + was + " and is " + (found == parts.end() ? "not there" : found->second));
    parts.erase(name);
  }
  for (const auto& [name, is] : parts) sentences.push_back(name + " was not there and is " + is);
  return sentences;
}

/// A failure names the file of a class, which lies elsewhere in a bundle.
std::string failure_without_folders(const json& cell) {
  static const std::regex kFolders("[^ ,]*/");
  return std::regex_replace(cell.at("failure").get<std::string>(), kFolders, "");
}

std::string difference_of_cell(const json& then, const json& now) {
  if (failure_without_folders(then) != failure_without_folders(now))
    return then_and_now("failure", then.at("failure"), now.at("failure"));
  for (const char* key : {"cell", "input"})
    if (then.at(key) != now.at(key)) return then_and_now(key, then.at(key), now.at(key));
  for (const auto& [name, value] : then.at("values").items())
    if (now.at("values").value(name, json()) != value)
      return then_and_now(name, value, now["values"].value(name, json()));
  return then.at("values") == now.at("values") ? "" : "there are more values than there were";
}

std::vector<std::string> other_cells(const std::vector<json>& then, const std::vector<json>& now) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string> sentences;
  std::size_t differ = 0;
  for (std::size_t k = 0; k < std::min(then.size(), now.size()); ++k) {
    const std::string difference = difference_of_cell(then[k], now[k]);
    if (difference.empty() || ++differ > kShown) continue;
    sentences.push_back(then[k].at("cell").get<std::string>() + ": " + difference);
  }
  if (then.size() != now.size()) sentences.push_back(then_and_now("the number of cells", then.size(), now.size()));
  if (differ > 0)
    sentences.insert(sentences.begin(), fmt::format("{} of {} cells came out differently", differ, then.size()));
  return sentences;
}

void compare_metric(const std::string& arm, const json& then, const json& now, RepeatedVerdict& told) {
  const std::string name = then.at("metric");
  const std::string what = arm + ", " + name + ": ";
  if (then.at("outcome") != now.at("outcome"))
    told.verdict.push_back(then_and_now(what + "outcome", then["outcome"], now["outcome"]));
  if (benchmark::is_measured(name)) {
    told.costs.push_back(then_and_now(what + "difference", then.at("difference"), now.at("difference")));
    return;
  }
  for (const char* number : kNumbersOfMetric)
    if (then.at(number) != now.at(number))
      told.verdict.push_back(then_and_now(what + number, then[number], now[number]));
}

void compare_verdicts(const json& then, const json& now, RepeatedVerdict& told) {
  if (then.size() != now.size())
    told.verdict.push_back(then_and_now("the number of compared arms", then.size(), now.size()));
  for (std::size_t k = 0; k < std::min(then.size(), now.size()); ++k) {
    const std::string arm = then[k].at("arm");
    if (now[k].at("arm") != arm || now[k].at("metrics").size() != then[k].at("metrics").size()) {
      told.verdict.push_back("arm " + arm + " is compared by other metrics");
      continue;
    }
    for (std::size_t m = 0; m < then[k]["metrics"].size(); ++m)
      compare_metric(arm, then[k]["metrics"][m], now[k]["metrics"][m], told);
  }
}

}  // namespace

RepeatedVerdict compare_with(const Bundle& bundle, const ResultFolder& repeated) {
  RepeatedVerdict told;
  const auto then = [&](const char* name) { return read_json(bundle.path_of(name)); };
  const auto now = [&](const char* name) { return read_json(repeated.file(name)); };
  told.made_with = other_parts(then("manifest.json"), now("manifest.json"));
  told.cells =
      other_cells(lines_of_file(bundle.path_of("results.jsonl")), lines_of_file(repeated.file("results.jsonl")));
  compare_verdicts(then("verdict.json"), now("verdict.json"), told);
  return told;
}

}  // namespace opal::ab
