#include <opal/plugin/testing/plugin_contract.hpp>

#include "plugin/elf_symbols.hpp"
#include "plugin/testing/violations.hpp"

#include <opal/plugin/plugin_registry.hpp>
#include <opal/plugin/testing/detector_contract.hpp>
#include <opal/plugin/testing/matcher_contract.hpp>
#include <opal/plugin/testing/pattern_contract.hpp>
#include <opal/plugin/testing/reader_contract.hpp>
#include <opal/plugin/testing/scorer_contract.hpp>
#include <opal/plugin/testing/store_contract.hpp>

#include <algorithm>
#include <array>

namespace opal::testing {
namespace {

using nlohmann::json;

/// A template function is told with what it returns in front, which may be "decltype (...)".
std::string without_decltype(const std::string& symbol) {
  if (!symbol.starts_with("decltype (")) return symbol;
  int depth = 0;
  for (std::size_t k = symbol.find('('); k < symbol.size(); ++k) {
    depth += symbol[k] == '(' ? 1 : symbol[k] == ')' ? -1 : 0;
    if (depth == 0) return symbol.substr(k + 1);
  }
  return symbol;
}

/// Inline parts of libraries that mark their classes as visible cannot be hidden by who uses them.
bool belongs_to_a_library(const std::string& symbol) {
  const std::string told = without_decltype(symbol), head = told.substr(0, told.find_first_of("<("));
  const std::array<const char*, 7> libraries{
      "std::", "__gnu_cxx::", "boost::", "pcl::", "ceres::", "pqxx::", "pybind11::"};
  return std::any_of(libraries.begin(), libraries.end(), [&](const char* name) {
    const std::size_t at = head.find(name);
    return at == 0 || (at != std::string::npos && head[at - 1] == ' ');
  });
}

/// Names of types of functions, which UBSan writes beside every function that it watches; the same wherever they stand.
bool is_type_of_a_function(const std::string& symbol) {
  return (symbol.starts_with("typeinfo for ") || symbol.starts_with("typeinfo name for ")) &&
         symbol.find('(') != std::string::npos && symbol.ends_with(')');
}

/// Linkers put these into any library that is linked with one that asks for them.
bool marks_a_section(const std::string& symbol) {
  return symbol == "_edata" || symbol == "_end" || symbol == "__bss_start";
}

bool is_allowed(const ExportedSymbol& symbol) {
  if (symbol.name == "opal_plugin_v1" || marks_a_section(symbol.name)) return true;
  return symbol.is_weak && (belongs_to_a_library(symbol.name) || is_type_of_a_function(symbol.name));
}

void check_exports(const std::string& file, Violations& violations) {
  for (const ExportedSymbol& symbol : exported_symbols(file)) {
    if (!is_allowed(symbol))
      violations.add("exports", "exports " + symbol.name +
                                    ", expected opal_plugin_v1 alone; build it with opal_add_plugin, or with "
                                    "-fvisibility=hidden -fvisibility-inlines-hidden");
  }
}

/// Calls `call` with the interface that a kind stands for, as `call.template operator()<FeatureDetector>()`.
template <class Call>
auto with_interface(PluginKind kind, Call&& call) {
  switch (kind) {
    case PluginKind::feature_detector: return call.template operator()<FeatureDetector>();
    case PluginKind::pattern_template: return call.template operator()<PatternTemplate>();
    case PluginKind::hypothesis_scorer: return call.template operator()<HypothesisScorer>();
    case PluginKind::log_source: return call.template operator()<LogSource>();
    case PluginKind::map_importer: return call.template operator()<MapImporter>();
    case PluginKind::scan_matcher: return call.template operator()<ScanMatcher>();
    case PluginKind::map_store: break;
  }
  return call.template operator()<MapStore>();
}

std::vector<std::string> violations_of(const FeatureDetector& object, const TypeInfo& type) {
  return detector_violations(object, type);
}
std::vector<std::string> violations_of(const PatternTemplate& object, const TypeInfo& type) {
  return pattern_violations(object, type);
}
std::vector<std::string> violations_of(const HypothesisScorer& object, const TypeInfo& type) {
  return scorer_violations(object, type);
}
std::vector<std::string> violations_of(const LogSource& object, const TypeInfo& type) {
  return log_source_violations(object, type);
}
std::vector<std::string> violations_of(const MapImporter& object, const TypeInfo& type) {
  return map_importer_violations(object, type);
}
std::vector<std::string> violations_of(const ScanMatcher& object, const TypeInfo& type) {
  return matcher_violations(object, type);
}
std::vector<std::string> violations_of(const MapStore& object, const TypeInfo& type) {
  return map_store_violations(object, type);
}

/// @return the refusal; empty if the object could be made.
std::string refusal(const PluginRegistry& registry, const RegisteredType& type, const json& options) {
  try {
    with_interface(type.kind, [&]<class T>() { (void)registry.make<T>(type.info.name, options); });
    return {};
  } catch (const PluginError& error) {
    return error.what();
  }
}

void expect_refused(const PluginRegistry& registry, const RegisteredType& type, const std::string& option,
                    const json& value, Violations& violations) {
  const std::string message = refusal(registry, type, {{option, value}});
  if (message.empty())
    violations.add("option " + option, type.info.name + " accepts " + value.dump() + " for the option " + option);
  else if (message.find(option) == std::string::npos)
    violations.add("option " + option, type.info.name + " refuses an option without naming it: " + message);
}

void check_options(const PluginRegistry& registry, const RegisteredType& type, Violations& violations) {
  expect_refused(registry, type, "no_such_option", 1, violations);
  for (const OptionInfo& option : type.options) {
    expect_refused(registry, type, option.name, json::array({1}), violations);
    if (option.minimum.is_number())
      expect_refused(registry, type, option.name, option.minimum.get<double>() - 1e9, violations);
    if (option.maximum.is_number())
      expect_refused(registry, type, option.name, option.maximum.get<double>() + 1e9, violations);
    if (option.description.empty())
      violations.add("described " + option.name, type.info.name + " does not describe its option " + option.name);
    // Both ends are in range, but need not go with the other defaults: a factory may refuse them.
    for (const json& end : {option.minimum, option.maximum})
      if (!end.is_null()) (void)refusal(registry, type, {{option.name, end}});
  }
}

void check_type(const PluginRegistry& registry, const RegisteredType& type, Violations& violations) {
  const std::string message = refusal(registry, type, json::object());
  if (!message.empty())
    return violations.add("defaults " + type.info.name, "cannot be used with its defaults: " + message);
  check_options(registry, type, violations);
  const auto sentences =
      with_interface(type.kind, [&]<class T>() { return violations_of(*registry.make<T>(type.info.name), type.info); });
  for (const std::string& sentence : sentences)
    violations.add(sentence, "has a type that breaks its contract: " + sentence);
}

}  // namespace

std::vector<std::string> plugin_violations(const std::string& file) {
  Violations violations(file);
  PluginRegistry registry;
  try {
    registry.load(file);
  } catch (const PluginError& error) {
    violations.add("load", std::string("is refused: ") + error.what());
    return violations.take();
  }
  check_exports(file, violations);
  for (const RegisteredType& type : registry.types()) check_type(registry, type, violations);
  return violations.take();
}

}  // namespace opal::testing
