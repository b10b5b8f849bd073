#pragma once

#include "tests/kit/temporary_folder.hpp"

#include <opal/map/map_importer.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace opal::test {

/// The importer from the built plugin, with its default options except these.
std::shared_ptr<const MapImporter> grid_importer(const nlohmann::json& options = nlohmann::json::object());

/// A grid of 0.05 m cells to draw on, all unknown at first. Cells count from the lower left corner, which is the origin
/// of the map; rectangles include their last column and row.
class DrawnGrid {
 public:
  static constexpr std::uint8_t kOccupied = 0;
  static constexpr std::uint8_t kUnknown = 205;
  static constexpr std::uint8_t kFree = 254;
  static constexpr double kCell_m = 0.05;

  DrawnGrid(int columns, int rows)
      : columns_(columns), rows_(rows), pixels_(static_cast<std::size_t>(columns * rows), kUnknown) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::uint8_t& at(int column, int row) { return pixels_[static_cast<std::size_t>(row * columns_ + column)]; }
  std::uint8_t at(int column, int row) const { return pixels_[static_cast<std::size_t>(row * columns_ + column)]; }

  DrawnGrid& fill(std::uint8_t shade, int left, int bottom, int right, int top);
  /// Free space with a wall of one cell around it.
  DrawnGrid& room(int left, int bottom, int right, int top);
  DrawnGrid shifted(int columns, int rows) const;
  DrawnGrid turned_left() const;  ///< by 90 degrees

  std::string pgm() const;
  std::string png() const;

 private:
  int columns_;
  int rows_;
  std::vector<std::uint8_t> pixels_;
};

/// A map_server yaml file for an image, with further lines.
std::string yaml_for(const std::string& image, const std::string& origin = "[0, 0, 0]", const std::string& more = "");

MapImport import(const DrawnGrid& grid, const nlohmann::json& options = nlohmann::json::object());

/// Geometries of one kind, in the order of the map.
template <class Shape>
std::vector<Shape> all(const SemanticMap& map) {
  std::vector<Shape> shapes;
  for (const MapFeature& feature : map.features())
    if (const auto* shape = std::get_if<Shape>(&feature.geometry)) shapes.push_back(*shape);
  return shapes;
}

}  // namespace opal::test
