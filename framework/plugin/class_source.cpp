#include "plugin/class_source.hpp"

#include "plugin/described_library.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/self_describing.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace opal {

SelfDescribing::~SelfDescribing() = default;

namespace {

constexpr std::string_view kEnding = ".py:";

bool is_identifier(std::string_view name) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(), is_part);
}

/// Without what the registry says before the cause: the class is named anyway.
std::string cause_in(const std::string& message) {
  const std::string before = "cannot be made: ";
  const std::size_t at = message.find(before);
  return at == std::string::npos ? message : message.substr(at + before.size());
}

}  // namespace

std::optional<ClassSource> read_class_source(const std::string& type) {
  const std::size_t at = type.rfind(kEnding);
  if (at == std::string::npos || at == 0) return std::nullopt;
  const std::string name = type.substr(at + kEnding.size());
  if (!is_identifier(name)) return std::nullopt;
  return ClassSource{type.substr(0, at + kEnding.size() - 1), name};
}

std::string host_of(PluginKind kind) {
  switch (kind) {
    case PluginKind::feature_detector: return "opal:PythonDetector";
    case PluginKind::pattern_template: return "opal:PythonPattern";
    case PluginKind::hypothesis_scorer: return "opal:PythonScorer";
    default: return "";
  }
}

nlohmann::json host_options(const ClassSource& source, const std::string& file, const nlohmann::json& options) {
  return {{"class", file + ":" + source.name}, {"options", options.dump()}};
}

template <class T>
std::shared_ptr<const T> make_of_class(const PluginRegistry& registry, const ClassSource& source,
                                       const std::string& file, const nlohmann::json& options) {
  const std::string host = host_of(kind_of_interface<T>()), name = source.file + ":" + source.name;
  if (!registry.has(host))
    throw PluginError(name + ": a class in Python, but there is no plugin " + host +
                      " to run it: Opal was built without Python");
  if (!std::filesystem::exists(file)) throw PluginError(name + ": there is no file " + file);
  try {
    return registry.make<T>(host, host_options(source, file, options));
  } catch (const PluginError& refusal) {
    throw PluginError(name + ": " + cause_in(refusal.what()));
  }
}

template <class T>
RegisteredType described_object(const T& object, const std::string& name, const std::string& file) {
  RegisteredType type;
  if (const auto* speaker = dynamic_cast<const SelfDescribing*>(&object)) type.info = speaker->type_info();
  type.info.name = name;
  type.kind = kind_of_interface<T>();
  type.plugin = name;
  type.file = file;
  type.on_request = true;
  return type;
}

#define OPAL_FOR_CLASSES_OF(T)                                                                                   \
  template std::shared_ptr<const T> make_of_class(const PluginRegistry&, const ClassSource&, const std::string&, \
                                                  const nlohmann::json&);                                        \
  template RegisteredType described_object(const T&, const std::string&, const std::string&);
OPAL_FOR_CLASSES_OF(FeatureDetector)
OPAL_FOR_CLASSES_OF(PatternTemplate)
OPAL_FOR_CLASSES_OF(HypothesisScorer)
#undef OPAL_FOR_CLASSES_OF

}  // namespace opal
