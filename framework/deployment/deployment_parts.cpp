#include <opal/common/error.hpp>
#include <opal/deployment/deployment.hpp>
#include "common/phrases.hpp"
#include "deployment/cache_folder.hpp"
#include "deployment/class_parts.hpp"
#include "deployment/pipeline_plan.hpp"
#include "deployment/types_made.hpp"
#include "patterns/consuming_template.hpp"

#include <algorithm>
#include <set>

namespace opal {
namespace {

std::string names_of(const std::vector<RegisteredType>& types, PluginKind kind) {
  std::vector<std::string> names;
  for (const RegisteredType& type : types)
    if (type.kind == kind) names.push_back(type.info.name);
  return listed(names, "none is loaded");
}

void expect_type(const PartConfig& part, PluginKind kind, const PluginRegistry& registry) {
  const std::string place = part.where + "/@type: \"" + part.type + "\"";
  const std::string expected =
      std::string(", expected a ") + name_of(kind) + " (" + names_of(registry.types(), kind) + ")";
  if (!registry.has(part.type))
    throw ConfigError(place + ", which no plugin offers" + expected + "; OPAL_PLUGIN_PATH adds folders of plugins");
  if (const PluginKind found = registry.type(part.type).kind; found != kind)
    throw ConfigError(place + ", which is a " + name_of(found) + expected);
  registry.expect_trusted(part.type);
}

/// A plugin names the option that it does not accept; the deployment adds the file and the place.
[[noreturn]] void refuse_options(const PartConfig& part, const std::string& complaint) {
  const std::string prefix = part.type + ": option ";
  if (complaint.rfind(prefix, 0) != 0) throw ConfigError(part.where + ": " + complaint);
  throw ConfigError(part.where + "/options/" + complaint.substr(prefix.size()));
}

void expect_options(const PartConfig& part, const PluginRegistry& registry) {
  std::string complaint;
  try {
    complete_options(part.type, registry.type(part.type).options, part.options);
    return;
  } catch (const PluginError& error) {
    complaint = error.what();
  }
  refuse_options(part, complaint);
}

void expect_usable(const PartConfig& part, PluginKind kind, const std::string& document,
                   const PluginRegistry& registry) {
  if (read_class_source(part.type)) return expect_class(part, kind, document, registry);
  expect_type(part, kind, registry);
  expect_options(part, registry);
}

using MaybeParts = std::optional<std::vector<PartConfig>>;

/// Calls `visit(part, kind)` for all that a deployment asks for by itself.
template <class Visit>
void for_each_part(const Deployment& deployment, const Visit& visit) {
  const auto visit_all = [&](const std::vector<PartConfig>& parts, PluginKind kind) {
    for (const PartConfig& part : parts) visit(part, kind);
  };
  if (deployment.detectors) visit_all(*deployment.detectors, PluginKind::feature_detector);
  if (deployment.patterns) visit_all(*deployment.patterns, PluginKind::pattern_template);
  visit_all(deployment.importers, PluginKind::map_importer);
  visit_all(deployment.log_sources, PluginKind::log_source);
  if (deployment.matcher) visit(*deployment.matcher, PluginKind::scan_matcher);
  for (const ScorerConfig& scorer : deployment.scorers) visit(scorer.part, PluginKind::hypothesis_scorer);
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Of what the map calls for: all of it with default options, or what the deployment lists, in its order.
std::vector<PartConfig> narrowed(const std::vector<std::string>& called_for, const MaybeParts& listed) {
  std::vector<PartConfig> chosen;
  if (listed) {
    for (const PartConfig& part : *listed)
      if (holds(called_for, part.type)) chosen.push_back(part);
  } else {
    for (const std::string& name : called_for) chosen.push_back({name, nlohmann::json::object(), ""});
  }
  return chosen;
}

/// What the map calls for, and what it leaves to the deployment to ask for.
std::vector<std::string> allowed_patterns(const PipelinePlan& plan, const MaybeParts& listed) {
  std::vector<std::string> allowed = plan.patterns;
  if (listed) allowed.insert(allowed.end(), plan.on_request.begin(), plan.on_request.end());
  return allowed;
}

/// One of `types`.
const RegisteredType& type_of(const std::string& name, const std::vector<RegisteredType>& types) {
  return *std::find_if(types.begin(), types.end(), [&](const auto& type) { return type.info.name == name; });
}

const TypeInfo& info_of(const std::string& name, const std::vector<RegisteredType>& types) {
  return type_of(name, types).info;
}

/// A pattern cannot be seen if the deployment has left out a detector that its features need.
std::vector<PartConfig> observable(std::vector<PartConfig> patterns, const std::vector<PartConfig>& detectors,
                                   const std::vector<RegisteredType>& types) {
  std::vector<std::string> produced;
  for (const PartConfig& detector : detectors)
    for (const std::string& type : info_of(detector.type, types).produces) produced.push_back(type);
  const auto unseen = [&](const std::string& type) { return !holds(produced, type); };
  std::erase_if(patterns, [&](const PartConfig& pattern) {
    const auto& consumes = info_of(pattern.type, types).consumes;
    return std::any_of(consumes.begin(), consumes.end(), unseen);
  });
  return patterns;
}

template <class T>
std::vector<Named<T>> make_all(const std::vector<PartConfig>& parts, const std::string& document,
                               const PluginRegistry& registry) {
  std::vector<Named<T>> made;
  for (const PartConfig& part : parts) made.push_back({part.type, make_part<T>(part, document, registry)});
  return made;
}

[[noreturn]] void refuse_empty(const Deployment& deployment, const char* key, const PipelinePlan& plan) {
  std::string message = deployment.file + ": /" + key + ": nothing is left to run with this map";
  for (const std::string& reason : plan.reasons) message += "\n  " + reason;
  throw ConfigError(message);
}

/// A detector that asks for the noise of a range, and is not told, is told what the lasers are described with; of
/// several, the most.
void tell_range_noise(std::vector<PartConfig>& detectors, const std::vector<LaserModel>& lasers,
                      const std::vector<RegisteredType>& types) {
  constexpr const char* kName = "range_sigma_m";
  double sigma_m = 0;
  for (const LaserModel& laser : lasers) sigma_m = std::max(sigma_m, laser.range_sigma_m);
  for (PartConfig& detector : detectors) {
    const std::vector<OptionInfo>& options = type_of(detector.type, types).options;
    const bool asks = std::any_of(options.begin(), options.end(), [&](const auto& o) { return o.name == kName; });
    if (asks && !detector.options.contains(kName)) detector.options[kName] = sigma_m;
  }
}

/// What a map calls for and a deployment leaves of it, before anything but classes is made.
struct CalledFor {
  std::vector<RegisteredType> types;  ///< that there are
  std::vector<PartConfig> detectors, patterns;
};

/// @throws ConfigError if no detector or no pattern is left.
CalledFor called_for(const Deployment& deployment, const PluginRegistry& registry, const SemanticMap& map) {
  CalledFor parts{types_for(deployment, registry), {}, {}};
  const PipelinePlan plan = plan_pipeline(map, deployment.lasers.front().id, parts.types);
  parts.detectors = narrowed(plan.detectors, deployment.detectors);
  tell_range_noise(parts.detectors, deployment.lasers, parts.types);
  parts.patterns = observable(narrowed(allowed_patterns(plan, deployment.patterns), deployment.patterns),
                              parts.detectors, parts.types);
  if (parts.detectors.empty()) refuse_empty(deployment, "detectors", plan);
  if (parts.patterns.empty()) refuse_empty(deployment, "patterns", plan);
  return parts;
}

/// Of one of the parts that are listed; none if it is not. All of them are checked.
nlohmann::json options_of(const std::string& type, const std::vector<PartConfig>& listed, PluginKind kind,
                          const std::string& document, const PluginRegistry& registry) {
  for (const PartConfig& part : listed) expect_usable(part, kind, document, registry);
  for (const PartConfig& part : listed)
    if (part.type == type) return part.options;
  return nlohmann::json::object();
}

}  // namespace

nlohmann::json importer_options(const Deployment& deployment, const PluginRegistry& registry,
                                const std::string& importer) {
  return options_of(importer, deployment.importers, PluginKind::map_importer, deployment.file,
                    trusted_by(deployment, registry));
}

nlohmann::json log_source_options(const Deployment& deployment, const PluginRegistry& registry,
                                  const std::string& log_source) {
  return options_of(log_source, deployment.log_sources, PluginKind::log_source, deployment.file,
                    trusted_by(deployment, registry));
}

void check_parts(const Deployment& deployment, const PluginRegistry& plugins) {
  const PluginRegistry registry = trusted_by(deployment, plugins);
  for_each_part(deployment,
                [&](const PartConfig& part, PluginKind kind) { expect_usable(part, kind, deployment.file, registry); });
}

std::vector<std::string> types_made(const Deployment& deployment, const PluginRegistry& plugins,
                                    const SemanticMap& map) {
  check_parts(deployment, plugins);
  const CalledFor called = called_for(deployment, trusted_by(deployment, plugins), map);
  std::set<std::string> types;
  const auto add = [&](const PartConfig& part, PluginKind kind) {
    types.insert(read_class_source(part.type) ? host_of(kind) : part.type);
  };
  for (const PartConfig& part : called.detectors) add(part, PluginKind::feature_detector);
  for (const PartConfig& part : called.patterns) add(part, PluginKind::pattern_template);
  for_each_part(deployment, add);
  return {types.begin(), types.end()};
}

LocalizerParts build_parts(const Deployment& deployment, const PluginRegistry& plugins,
                           std::shared_ptr<const SemanticMap> map) {
  check_parts(deployment, plugins);
  const PluginRegistry registry = trusted_by(deployment, plugins);
  const CalledFor called = called_for(deployment, registry, *map);

  LocalizerParts parts;
  parts.map = std::make_shared<const MapView>(std::move(map), deployment.lasers.front().id,
                                              cache_folder("OPAL_PREPARED_CACHE", "prepared").string());
  parts.lasers = deployment.lasers;
  parts.odometry = deployment.odometry;
  parts.keyframes = deployment.keyframes;
  parts.local_map = deployment.local_map;
  if (deployment.matcher)
    parts.matcher = registry.make<ScanMatcher>(deployment.matcher->type, deployment.matcher->options);
  parts.detectors = make_all<FeatureDetector>(called.detectors, deployment.file, registry);
  parts.patterns = make_all<PatternTemplate>(called.patterns, deployment.file, registry);
  for (Named<PatternTemplate>& pattern : parts.patterns)
    pattern.part = consuming(std::move(pattern.part), info_of(pattern.name, called.types).consumes);
  for (const ScorerConfig& scorer : deployment.scorers)
    parts.scorers.push_back({scorer.name.empty() ? scorer.part.type : scorer.name,
                             make_part<HypothesisScorer>(scorer.part, deployment.file, registry), scorer.role,
                             scorer.weight});
  parts.stages = deployment.stages;
  return parts;
}

}  // namespace opal
