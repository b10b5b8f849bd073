#include "deployment/class_parts.hpp"

#include "deployment/class_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

namespace opal {
namespace {

bool is_class(const PartConfig& part) { return read_class_source(part.type).has_value(); }

template <class T>
void add_classes(const std::optional<std::vector<PartConfig>>& parts, const std::string& document,
                 const PluginRegistry& registry, std::vector<RegisteredType>& types) {
  if (!parts) return;
  for (const PartConfig& part : *parts)
    if (is_class(part))
      types.push_back(
          described_object(*make_part<T>(part, document, registry), part.type, read_class_source(part.type)->file));
}

/// Of detectors, templates and scorers.
std::vector<PartConfig> classes_in(const Deployment& deployment) {
  std::vector<PartConfig> classes;
  const auto add = [&](const PartConfig& part) {
    if (is_class(part)) classes.push_back(part);
  };
  for (const auto* parts : {&deployment.detectors, &deployment.patterns})
    if (*parts) std::for_each((*parts)->begin(), (*parts)->end(), add);
  for (const ScorerConfig& scorer : deployment.scorers) add(scorer.part);
  return classes;
}

}  // namespace

void expect_class(const PartConfig& part, PluginKind kind, const std::string& document,
                  const PluginRegistry& registry) {
  if (kind == PluginKind::feature_detector)
    make_part<FeatureDetector>(part, document, registry);
  else if (kind == PluginKind::pattern_template)
    make_part<PatternTemplate>(part, document, registry);
  else if (kind == PluginKind::hypothesis_scorer)
    make_part<HypothesisScorer>(part, document, registry);
  else
    throw ConfigError(part.where + ": " + part.type +
                      ": a class in Python, expected a plugin's type: no plugin runs such ones");
}

std::vector<RegisteredType> types_for(const Deployment& deployment, const PluginRegistry& registry) {
  std::vector<RegisteredType> types = registry.types();
  const std::string& file = deployment.file;
  add_classes<FeatureDetector>(deployment.detectors, file, registry, types);
  add_classes<PatternTemplate>(deployment.patterns, file, registry, types);
  return types;
}

std::vector<std::string> class_files(const Deployment& deployment) {
  std::set<std::string> files;
  for (const PartConfig& part : classes_in(deployment))
    files.insert(beside(deployment.file, read_class_source(part.type)->file));
  return {files.begin(), files.end()};
}

namespace {

/// Calls with every text of a list's objects under a key, which it may change.
void for_texts(nlohmann::json& configuration, const char* list, const char* key,
               const std::function<void(nlohmann::json&)>& change) {
  if (!configuration.contains(list) || !configuration[list].is_array()) return;
  for (nlohmann::json& object : configuration[list])
    if (object.is_object() && object.contains(key) && object[key].is_string()) change(object[key]);
}

}  // namespace

nlohmann::json with_classes_named(nlohmann::json configuration,
                                  const std::function<std::string(const ClassSource&)>& type_of) {
  for (const char* list : {"detectors", "patterns", "scorers"})
    for_texts(configuration, list, "@type", [&](nlohmann::json& type) {
      if (const auto source = read_class_source(type)) type = type_of(*source);
    });
  for_texts(configuration, "trusted_plugins", "file", [&](nlohmann::json& file) {
    const std::string anything = ":Class";  // a file is named like one of its classes
    if (const auto source = read_class_source(file.get<std::string>() + anything))
      file = read_class_source(type_of(*source))->file;
  });
  return configuration;
}

nlohmann::json with_classes_beside(nlohmann::json configuration, const std::string& document) {
  return with_classes_named(std::move(configuration), [&](const ClassSource& source) {
    return std::filesystem::absolute(beside(document, source.file)).string() + ":" + source.name;
  });
}

}  // namespace opal
