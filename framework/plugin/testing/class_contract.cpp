#include <opal/plugin/testing/detector_contract.hpp>
#include <opal/plugin/testing/pattern_contract.hpp>
#include <opal/plugin/testing/plugin_contract.hpp>
#include <opal/plugin/testing/scorer_contract.hpp>

#include "plugin/class_source.hpp"

#include <opal/plugin/plugin_folders.hpp>

#include <optional>

namespace opal::testing {
namespace {

PluginRegistry usual_plugins() {
  PluginRegistry registry;
  for (const std::string& folder : plugin_folders()) (void)registry.announce_all(folder);
  return registry;
}

/// Of a class that is of this kind; nullopt: it is of another one.
template <class T, class Contract>
std::optional<std::vector<std::string>> violations_as(const PluginRegistry& registry, const ClassSource& source,
                                                      const Contract& contract) {
  const std::string name = source.file + ":" + source.name;
  try {
    const auto object = make_of_class<T>(registry, source, source.file, nlohmann::json::object());
    return contract(*object, described_object(*object, name, source.file).info);
  } catch (const PluginError& refusal) {
    const std::string words = refusal.what();
    if (words.find("has no method") != std::string::npos) return std::nullopt;
    return std::vector<std::string>{words};
  }
}

}  // namespace

std::vector<std::string> class_violations(const std::string& source) {
  const auto named = read_class_source(source);
  if (!named) return {source + ": no class of a file, expected FILE.py:CLASS"};
  const PluginRegistry registry = usual_plugins();
  const auto detector = [](const auto& object, const auto& type) { return detector_violations(object, type); };
  const auto pattern = [](const auto& object, const auto& type) { return pattern_violations(object, type); };
  const auto scorer = [](const auto& object, const auto& type) { return scorer_violations(object, type); };
  if (auto found = violations_as<HypothesisScorer>(registry, *named, scorer)) return *found;
  if (auto found = violations_as<FeatureDetector>(registry, *named, detector)) return *found;
  if (auto found = violations_as<PatternTemplate>(registry, *named, pattern)) return *found;
  return {source + ": has none of the methods score, detect and match, expected a scorer, a detector or a template"};
}

}  // namespace opal::testing
