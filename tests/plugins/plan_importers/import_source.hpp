#pragma once

#include "tests/kit/import_report.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <algorithm>
#include <string>
#include <vector>

/// Imports a text with the plugin of this name.
inline opal::MapImport import_text(const std::string& plugin, const std::string& type, const std::string& file_name,
                                   const std::string& text, const nlohmann::json& options = nlohmann::json::object()) {
  opal::PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/" + plugin + ".so");
  const opal::TemporaryFile file(file_name, text);
  return registry.make<opal::MapImporter>(type, options)->import(file.path());
}

template <class Shape>
std::vector<Shape> all(const opal::SemanticMap& map) {
  std::vector<Shape> shapes;
  for (const opal::MapFeature& feature : map.features())
    if (const auto* shape = std::get_if<Shape>(&feature.geometry); shape != nullptr && !feature.sensor.empty())
      shapes.push_back(*shape);
  return shapes;
}

inline bool has_face(const opal::SemanticMap& map, const opal::Point& begin, const opal::Point& end) {
  const auto faces = all<opal::Segment>(map);
  return std::any_of(faces.begin(), faces.end(), [&](const opal::Segment& face) {
    return (face.begin - begin).norm() < 1e-6 && (face.end - end).norm() < 1e-6;
  });
}

inline const opal::ImportedElement& thing(const opal::MapImport& imported, const std::string& id) {
  const auto found = std::find_if(imported.elements.begin(), imported.elements.end(),
                                  [&](const opal::ImportedElement& element) { return element.id == id; });
  if (found == imported.elements.end()) throw std::runtime_error("the report says nothing of " + id);
  return *found;
}
