#include "session.hpp"

#include <opal/error.hpp>
#include <opal/plugin/plugin_folders.hpp>

#include <filesystem>
#include <iostream>

namespace {

namespace fs = std::filesystem;

template <class T>
std::shared_ptr<const T> recognizing(const opal::PluginRegistry& registry, opal::PluginKind kind,
                                     const std::string& path, const nlohmann::json& options = nlohmann::json::object()) {
  for (const opal::RegisteredType& type : registry.types()) {
    if (type.kind != kind) continue;
    auto part = registry.make<T>(type.info.name);
    if (part->recognizes(path)) return options.empty() ? part : registry.make<T>(type.info.name, options);
  }
  return nullptr;
}

bool is_document(const std::string& source) {
  const std::string extension = fs::path(source).extension().string();
  return extension == ".jsonld" || extension == ".json";
}

}  // namespace

opal::PluginRegistry load_plugins() {
  opal::PluginRegistry registry;
  for (const std::string& folder : opal::plugin_folders())
    for (const std::string& refusal : registry.load_all(folder)) std::cerr << "plugin refused: " << refusal << '\n';
  return registry;
}

opal::MapImport import_map(const opal::PluginRegistry& registry, const std::string& source, double thicken_m) {
  if (!fs::exists(source)) throw opal::MapError(source + ": does not exist");
  nlohmann::json options = nlohmann::json::object();
  if (thicken_m > 0) options["thicken_m"] = thicken_m;
  const auto importer = recognizing<opal::MapImporter>(registry, opal::PluginKind::map_importer, source, options);
  if (!importer) throw opal::MapError(source + ": no importer recognizes this file");
  return importer->import(source);
}

std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& registry, const std::string& source) {
  return is_document(source) ? opal::SemanticMap::read(source) : import_map(registry, source).map;
}

std::shared_ptr<const opal::SemanticMap> load_map(const opal::PluginRegistry& registry, const std::string& source,
                                                  const opal::MapDamage& damage) {
  if (is_document(source) && damage.thick_m > 0)
    throw opal::ConfigError(source + ": damage thick= is done to grids before they are imported, found a document");
  return opal::damaged_map(is_document(source) ? *opal::SemanticMap::read(source)
                                               : *import_map(registry, source, damage.thick_m).map,
                           damage);
}

std::unique_ptr<opal::LogReader> open_log(const opal::PluginRegistry& registry, const std::string& path) {
  if (!fs::exists(path)) throw opal::LogError(path + ": does not exist");
  const auto source = recognizing<opal::LogSource>(registry, opal::PluginKind::log_source, path);
  if (!source) throw opal::LogError(path + ": no log source recognizes this file");
  return source->open(path);
}

std::string shipped_config(const std::string& name) {
  const fs::path program = fs::canonical("/proc/self/exe").parent_path();
  for (const char* folder : {"../../../configs", "../share/opal/configs"})
    if (const fs::path file = program / folder / name; fs::exists(file)) return fs::canonical(file).string();
  throw opal::ConfigError(name + ": is neither beside the sources nor installed; name a configuration with --config");
}
