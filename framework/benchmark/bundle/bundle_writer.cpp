#include "benchmark/bundle/bundle_writer.hpp"

#include "common/digest/sha256.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "common/json/config_object.hpp"
#include "common/text_file.hpp"
#include "common/whole_file.hpp"
#include "deployment/class_files.hpp"

#include <fmt/format.h>

#include <map>

namespace opal::ab {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

/// Puts files into a bundle and lists them.
class BundleFiles {
 public:
  explicit BundleFiles(std::string folder) : folder_(std::move(folder)) {}

  void write(const std::string& name, const std::string& text) {
    make_folder(path_of(name).parent_path().string());
    write_text(path_of(name).string(), text);
    list(name, path_of(name), true);
  }
  void copy(const fs::path& source, const std::string& name, std::uint64_t largest_bytes = UINT64_MAX) {
    const bool included = fs::file_size(source) <= largest_bytes;
    if (included) {
      make_folder(path_of(name).parent_path().string());
      fs::copy_file(source, path_of(name));
    }
    list(name, source, included);
  }
  const std::vector<BundledFile>& all() const { return files_; }

 private:
  fs::path path_of(const std::string& name) const { return fs::path(folder_) / name; }
  void list(const std::string& name, const fs::path& where, bool included) {
    files_.push_back({name, sha256_of_file(where.string()), fs::file_size(where), included});
  }

  std::string folder_;
  std::vector<BundledFile> files_;
};

/// Copies what an experiment names, and says where it is in the bundle.
class ExperimentCopy {
 public:
  ExperimentCopy(const Experiment& experiment, benchmark::WorldSource& worlds, BundleFiles& files,
                 std::uint64_t largest_bytes)
      : experiment_(experiment), worlds_(worlds), files_(files), largest_bytes_(largest_bytes) {}

  void write() {
    json document = experiment_.document;
    for (std::size_t k = 0; k < experiment_.arms.size(); ++k) place_arm(experiment_.arms[k], document["arms"][k]);
    const std::size_t sites = document.value("sites", json::array()).size();
    for (std::size_t k = 0; k < sites; ++k) place_site(experiment_.scenarios[k], document["sites"][k]);
    for (std::size_t k = sites; k < experiment_.scenarios.size(); ++k) place_map(experiment_.scenarios[k], document);
    files_.write(kBundledExperiment, document.dump(1) + "\n");
  }

 private:
  /// The deployment with its overrides is one document; classes and plugins lie beside it.
  void place_arm(const Arm& arm, json& object) {
    const json configuration =
        with_classes_named(arm.configuration, [&](const ClassSource& source) { return placed_class(arm, source); });
    files_.write("arms/" + arm.name + ".jsonld", configuration.dump(1) + "\n");
    object["deployment"] = "arms/" + arm.name + ".jsonld";
    object.erase("overrides");
    if (arm.plugin_folders.empty()) return;
    object["plugins"] = json::array();
    for (std::size_t k = 0; k < arm.plugin_folders.size(); ++k) {
      const std::string name = fmt::format("plugins/{}/{}", arm.name, k);
      for (const auto& entry : fs::recursive_directory_iterator(arm.plugin_folders[k]))
        if (entry.is_regular_file())
          files_.copy(entry.path(), name + "/" + fs::relative(entry.path(), arm.plugin_folders[k]).generic_string());
      object["plugins"].push_back(name);
    }
  }

  /// Copies the file of a class. @return its name as a type, from `arms/`.
  std::string placed_class(const Arm& arm, const ClassSource& source) {
    const std::string file = fs::absolute(beside(arm.deployment.file, source.file)).string();
    const auto [known, is_new] = classes_.emplace(
        file, fmt::format("classes/{}/{}/{}", arm.name, classes_.size() + 1, fs::path(file).filename().string()));
    if (is_new) files_.copy(file, known->second);
    return "../" + known->second + ":" + source.name;
  }

  void place_site(const Scenario& scenario, json& object) {
    const std::string prefix = std::get<RecordedPlace>(scenario.source).prefix;
    const std::string place = "places/" + scenario.name + "/";
    const ordered_json inputs = worlds_.inputs(scenario);
    for (const auto& [name, digest] : inputs.items())
      files_.copy(fs::path(prefix).parent_path() / name, place + name, largest_bytes_);
    object["prefix"] = place + fs::path(prefix).filename().string();
    object["name"] = scenario.name;
  }

  /// A map that a scenario names is there as it was understood, whatever it was imported from.
  void place_map(const Scenario& scenario, json& document) {
    if (std::get<SimulatedDrives>(scenario.source).building) return;
    const std::string name = "maps/" + scenario.name + ".map.jsonld";
    files_.write(name, worlds_.map_of(scenario)->to_json_ld().dump(1) + "\n");
    for (json& object : document["simulated"])
      if (object["name"] == scenario.name) object["map"] = name;
  }

  const Experiment& experiment_;
  benchmark::WorldSource& worlds_;
  BundleFiles& files_;
  std::uint64_t largest_bytes_;
  std::map<std::string, std::string> classes_;  ///< in the bundle, by the file that they come from
};

ordered_json json_of(const std::vector<BundledFile>& files) {
  auto list = ordered_json::array();
  for (const BundledFile& file : files) {
    list.push_back({{"name", file.name}, {"sha256", file.sha256}, {"bytes", file.bytes}});
    if (!file.included) list.back()["included"] = false;
  }
  return list;
}

/// By scenario.
ordered_json seeds_of(const Experiment& experiment) {
  auto seeds = ordered_json::object();
  for (const Scenario& scenario : experiment.scenarios) seeds[scenario.name] = scenario.seeds;
  return seeds;
}

ordered_json verdict_sentences(const ResultFolder& results) {
  auto sentences = ordered_json::array();
  for (const json& verdict : read_json(results.file("verdict.json")))
    sentences.push_back(verdict.at("sentence").get<std::string>());
  return sentences;
}

void expect_new_folder(const std::string& folder) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw ConfigError(folder + ": is a file, expected a folder that is empty or not there");
  if (fs::exists(folder) && !fs::is_empty(folder))
    throw ConfigError(folder + ": holds something, expected a folder that is empty or not there");
}

}  // namespace

Bundle write_bundle(const Experiment& experiment, const ordered_json& manifest, benchmark::WorldSource& worlds,
                    const ResultFolder& results, const BundleOptions& options) {
  expect_new_folder(options.folder);
  BundleFiles files(options.folder);
  ExperimentCopy(experiment, worlds, files, options.largest_bytes).write();
  for (const char* name : {"results.jsonl", "verdict.json", "manifest.json"}) files.copy(results.file(name), name);
  const ordered_json document{{"format", 1},
                              {"experiment", experiment.name},
                              {"command", options.command},
                              {"repeat", "opal ab repeat " + fs::path(options.folder).filename().string()},
                              {"verdict", verdict_sentences(results)},
                              {"opal", manifest.at("opal")},
                              {"seeds", seeds_of(experiment)},
                              {"files", json_of(files.all())}};
  write_text((fs::path(options.folder) / kBundleFile).string(), document.dump(1) + "\n");
  return {options.folder, files.all()};
}

}  // namespace opal::ab
