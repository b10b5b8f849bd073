#pragma once

#include "drawing/drawing.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace opal::cli {

/// A map under its name, and nothing besides.
inline DrawingScene scene_of(const std::shared_ptr<const SemanticMap>& map) {
  DrawingScene scene;
  scene.title = map->name();
  scene.map = map;
  return scene;
}

/// The options of every verb that also draws what it has made.
struct PictureFiles {
  std::string svg, png;

  void add_to(CLI::App& verb, const std::string& what = "also draw the map into this file") {
    verb.add_option("--svg", svg, what);
    verb.add_option("--png", png, "the same as a PNG");
  }

  void write(const DrawingScene& scene) const {
    if (!svg.empty()) write_svg(scene, svg);
    if (!png.empty()) write_png(scene, png);
  }

  /// A map, with coordinates at the edges.
  void write_with_coordinates(const std::shared_ptr<const SemanticMap>& map) const {
    DrawingScene scene = scene_of(map);
    scene.coordinates = true;
    write(scene);
  }
};

}  // namespace opal::cli
