#include "deployment/class_parts.hpp"

#include "deployment/class_files.hpp"

#include <set>

namespace opal {
namespace {

void find_class(PartConfig& part, const std::string& document) {
  if (const auto source = read_class_source(part.type)) part.code = beside_document(source->file, document);
}

template <class T>
void add_classes(const std::optional<std::vector<PartConfig>>& parts, PluginKind kind, const PluginRegistry& registry,
                 std::vector<RegisteredType>& types) {
  if (!parts) return;
  for (const PartConfig& part : *parts)
    if (!part.code.empty())
      types.push_back(described_object(*make_part<T>(part, kind, registry), kind, part.type, part.code));
}

}  // namespace

void expect_class(const PartConfig& part, PluginKind kind, const PluginRegistry& registry) {
  if (kind == PluginKind::feature_detector)
    make_part<FeatureDetector>(part, kind, registry);
  else if (kind == PluginKind::pattern_template)
    make_part<PatternTemplate>(part, kind, registry);
  else
    make_part<HypothesisScorer>(part, kind, registry);
}

std::vector<RegisteredType> types_for(const Deployment& deployment, const PluginRegistry& registry) {
  std::vector<RegisteredType> types = registry.types();
  add_classes<FeatureDetector>(deployment.detectors, PluginKind::feature_detector, registry, types);
  add_classes<PatternTemplate>(deployment.patterns, PluginKind::pattern_template, registry, types);
  return types;
}

void find_classes(Deployment& deployment, const std::string& file) {
  for (auto* parts : {&deployment.detectors, &deployment.patterns})
    if (*parts)
      for (PartConfig& part : **parts) find_class(part, file);
  for (ScorerConfig& scorer : deployment.scorers) find_class(scorer.part, file);
}

std::vector<std::string> class_files(const Deployment& deployment) {
  std::set<std::string> files;
  const auto add = [&](const PartConfig& part) {
    if (!part.code.empty()) files.insert(part.code);
  };
  for (const auto* parts : {&deployment.detectors, &deployment.patterns})
    if (*parts)
      for (const PartConfig& part : **parts) add(part);
  for (const ScorerConfig& scorer : deployment.scorers) add(scorer.part);
  return {files.begin(), files.end()};
}

nlohmann::json with_classes_beside(nlohmann::json configuration, const std::string& document) {
  for (const char* key : {"detectors", "patterns", "scorers"}) {
    if (!configuration.contains(key) || !configuration[key].is_array()) continue;
    for (nlohmann::json& part : configuration[key]) {
      if (!part.is_object() || !part.contains("@type") || !part["@type"].is_string()) continue;
      if (const auto source = read_class_source(part["@type"]))
        part["@type"] = beside_document(source->file, document) + ":" + source->name;
    }
  }
  return configuration;
}

}  // namespace opal
