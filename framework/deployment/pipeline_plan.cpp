#include "deployment/pipeline_plan.hpp"

#include "common/phrases.hpp"
#include "plugin/class_source.hpp"

#include <algorithm>
#include <set>

namespace opal {
namespace {

using Names = std::set<std::string>;

/// What the map says, for one sensor.
struct MapDemand {
  std::map<std::string, int> features_by_type;
  std::map<std::string, int> patterns_by_template;
};

MapDemand demand_of(const SemanticMap& map, const std::string& sensor) {
  MapDemand demand;
  for (const MapFeature& feature : map.features())
    if (feature.sensor == sensor) ++demand.features_by_type[feature.type];
  for (const MapPattern& pattern : map.patterns())
    if (map.feature(pattern.features.front()).sensor == sensor) ++demand.patterns_by_template[pattern.pattern_template];
  return demand;
}

/// Types by name, so that the plan does not depend on the order in which plugins were found.
std::vector<RegisteredType> of_kind(PluginKind kind, const std::vector<RegisteredType>& types) {
  std::vector<RegisteredType> chosen;
  for (const RegisteredType& type : types)
    if (type.kind == kind) chosen.push_back(type);
  std::ranges::sort(chosen, [](const RegisteredType& a, const RegisteredType& b) { return a.info.name < b.info.name; });
  return chosen;
}

/// What runs classes has nothing of its own to run: a map cannot call for it, and there is no reason to tell.
bool runs_classes(const std::string& type) {
  return type == host_of(PluginKind::feature_detector) || type == host_of(PluginKind::pattern_template);
}

class Planner {
 public:
  Planner(const SemanticMap& map, const std::string& sensor) : sensor_(sensor), demand_(demand_of(map, sensor)) {}

  PipelinePlan plan(const std::vector<RegisteredType>& types) {
    for (const RegisteredType& detector : of_kind(PluginKind::feature_detector, types))
      consider_detector(detector.info);
    report_unseen();
    for (const RegisteredType& pattern : of_kind(PluginKind::pattern_template, types)) consider_pattern(pattern);
    report_missing_templates(types);
    return std::move(plan_);
  }

 private:
  void consider_detector(const TypeInfo& detector) {
    std::vector<std::string> found;
    for (const std::string& type : detector.produces)
      if (demand_.features_by_type.contains(type))
        found.push_back(std::to_string(demand_.features_by_type.at(type)) + " " + type);
    if (found.empty()) {
      reject(detector, "the map holds no " +
                           (detector.produces.empty() ? "feature type that it produces" : listed(detector.produces)) +
                           " for " + sensor_);
      return;
    }
    accept(detector, plan_.detectors, "the map holds " + listed(found) + " for " + sensor_);
    produced_.insert(detector.produces.begin(), detector.produces.end());
  }

  void report_unseen() {
    for (const auto& [type, count] : demand_.features_by_type)
      if (!produced_.contains(type))
        plan_.reasons.push_back(type + ": no detector produces it; " + std::to_string(count) +
                                " features of the map stay unseen");
  }

  void consider_pattern(const RegisteredType& registered) {
    const TypeInfo& pattern = registered.info;
    const bool named = demand_.patterns_by_template.contains(pattern.name);
    if (!named && !demand_.patterns_by_template.empty()) {
      reject(pattern, "the map's patterns name other templates only");
      return;
    }
    for (const std::string& type : pattern.consumes)
      if (!produced_.contains(type) || !demand_.features_by_type.contains(type)) {
        reject(pattern, "it consumes " + type +
                            (produced_.contains(type) ? ", which the map does not hold for " + sensor_
                                                      : ", which no running detector produces"));
        return;
      }
    if (produced_.empty()) {
      reject(pattern, "no detector runs");
      return;
    }
    if (registered.on_request && !named) {
      plan_.on_request.push_back(pattern.name);
      reject(pattern, "nothing asks for it: it runs where the map's patterns or a deployment name it");
      return;
    }
    const std::string consumed = pattern.consumes.empty() ? "any feature" : listed(pattern.consumes);
    accept(pattern, plan_.patterns,
           "it consumes " + consumed +
               (named ? ", and " + std::to_string(demand_.patterns_by_template.at(pattern.name)) +
                            " patterns of the map name it"
                      : ""));
  }

  void report_missing_templates(const std::vector<RegisteredType>& types) {
    for (const auto& [name, count] : demand_.patterns_by_template) {
      const auto offers = [&name = name](const RegisteredType& type) {
        return type.kind == PluginKind::pattern_template && type.info.name == name;
      };
      if (std::ranges::none_of(types, offers))
        plan_.reasons.push_back(name + ": no plugin offers it; " + std::to_string(count) +
                                " patterns of the map stay unused");
    }
  }

  void accept(const TypeInfo& type, std::vector<std::string>& running, const std::string& reason) {
    running.push_back(type.name);
    plan_.reasons.push_back(type.name + ": runs, " + reason);
  }
  void reject(const TypeInfo& type, const std::string& reason) {
    if (runs_classes(type.name)) return;
    plan_.reasons.push_back(type.name + ": does not run, " + reason);
  }

  const std::string& sensor_;
  MapDemand demand_;
  Names produced_;
  PipelinePlan plan_;
};

}  // namespace

PipelinePlan plan_pipeline(const SemanticMap& map, const std::string& sensor,
                           const std::vector<RegisteredType>& types) {
  return Planner(map, sensor).plan(types);
}

}  // namespace opal
