#include "benchmark/ab/documents/experiment.hpp"

#include "benchmark/ab/documents/scenario_reader.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "common/json/config_object.hpp"
#include "common/phrases.hpp"
#include "deployment/class_files.hpp"

#include <filesystem>

namespace opal::ab {
namespace {

namespace fs = std::filesystem;
using Shipped = std::function<std::string(const std::string&)>;

std::vector<std::string> resolved(const std::vector<std::string>& paths, const std::string& document) {
  std::vector<std::string> all;
  for (const std::string& path : paths) all.push_back(beside(document, path));
  return all;
}

/// The message of a configuration names its file and the arm, as its text stands nowhere.
std::string name_of_configuration(const std::string& file, const std::string& arm, bool overridden) {
  return overridden ? file + " (with the overrides of arm " + arm + ")" : file;
}

Arm read_arm(ConfigObject object, const std::string& document, const Shipped& shipped) {
  Arm arm;
  arm.name = read_name(object);
  object.text("comment", "");
  const std::string named = object.text("deployment", "default");
  const std::string file = named.ends_with(".jsonld") ? beside(document, named) : shipped(named);
  arm.configuration = read_json(file);
  const bool overridden = object.object("overrides").has_value();
  if (overridden) arm.configuration.merge_patch(with_classes_beside(object.any("overrides"), document));
  arm.deployment = parse_deployment(arm.configuration.dump(), name_of_configuration(file, arm.name, overridden));
  arm.plugin_folders = resolved(object.texts("plugins"), document);
  for (const std::string& folder : arm.plugin_folders)
    if (!fs::is_directory(folder)) throw ConfigError(object.where("plugins") + ": " + folder + ": expected a folder");
  object.expect_no_more();
  return arm;
}

/// What the robot is given must be the same in all arms, or they are not compared on the same.
void expect_same_inputs(const Arm& arm, const Arm& baseline, const ConfigObject& where) {
  for (const char* key : {"map", "overlays", "importers", "sensor"}) {
    const auto value = [&](const Arm& one) { return one.configuration.value(key, nlohmann::json()); };
    if (value(arm) == value(baseline)) continue;
    throw ConfigError(where.where() + ": arm " + arm.name + " has another \"" + key + "\" than " + baseline.name +
                      ", expected the same inputs in all arms");
  }
  if (!arm.deployment.overlays.empty())
    throw ConfigError(where.where() + ": the deployment of arm " + arm.name +
                      " has overlays, expected none: maps are the scenarios'");
}

std::vector<Arm> read_arms(ConfigObject& document, const std::string& file, const Shipped& shipped) {
  const auto objects = document.list("arms");
  if (!objects || objects->size() < 2) document.refuse("arms", "a list of at least two arms");
  std::vector<Arm> arms;
  for (const ConfigObject& object : *objects) {
    Arm arm = read_arm(object, file, shipped);
    for (const Arm& other : arms)
      if (other.name == arm.name) object.refuse("name", "a name that no other arm has");
    if (!arms.empty()) expect_same_inputs(arm, arms.front(), object);
    arms.push_back(std::move(arm));
  }
  return arms;
}

std::size_t read_baseline(ConfigObject& document, const std::vector<Arm>& arms) {
  const std::string name = document.text("baseline", arms.front().name);
  for (std::size_t k = 0; k < arms.size(); ++k)
    if (arms[k].name == name) return k;
  document.refuse("baseline", "the name of an arm: " + listed_by(arms, &Arm::name));
}

/// Only scorers can judge the same hypotheses.
void expect_same_but_scorers(const Experiment& experiment) {
  const auto others = [](nlohmann::json configuration) {
    for (const char* key : {"scorers", "name", "comment"}) configuration.erase(key);
    return configuration;
  };
  const Arm& baseline = experiment.arms[experiment.baseline];
  for (const Arm& arm : experiment.arms)
    if (others(arm.configuration) != others(baseline.configuration))
      throw ConfigError(experiment.file + ": /mode: \"observe\", but arm " + arm.name + " differs from " +
                        baseline.name + " by more than its scorers, expected mode \"decide\"");
}

CellLimits read_limits(ConfigObject object) {
  CellLimits limits;
  limits.wall_s = object.number("cell_s", limits.wall_s, {0.1, 86400});
  limits.memory_mb = object.number("memory_mb", limits.memory_mb, {50, 1e6});
  object.expect_no_more();
  return limits;
}

}  // namespace

Experiment read_experiment(const std::string& path, const Shipped& shipped) {
  Experiment experiment;
  experiment.file = path;
  experiment.document = read_json(path);
  ConfigObject document(experiment.document, path);
  document.expect_type("opal:Experiment");
  experiment.name = document.text("name", fs::path(path).stem().string());
  document.text("comment", "");
  experiment.arms = read_arms(document, path, shipped);
  experiment.baseline = read_baseline(document, experiment.arms);
  experiment.scenarios = read_scenarios(document, path);
  const std::string mode = document.text("mode", "decide");
  if (mode != "decide" && mode != "observe") document.refuse("mode", "\"decide\" or \"observe\"");
  experiment.observes = mode == "observe";
  if (experiment.observes) expect_same_but_scorers(experiment);
  experiment.metrics = document.texts("metrics");
  experiment.looks = document.integer("looks", experiment.looks, {1, 100});
  if (auto limits = document.object("limits")) experiment.limits = read_limits(*limits);
  document.expect_no_more();
  return experiment;
}

}  // namespace opal::ab
