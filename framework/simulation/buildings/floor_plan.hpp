#pragma once

#include "simulation/buildings/box.hpp"

#include <string>
#include <vector>

namespace opal::simulation {

/// What an architect draws: floor cut out of the solid, and what stands on it. Strokes are painted in order, so later
/// ones cover earlier ones. Frame `map`, lengths in whole centimetres.
class FloorPlan {
 public:
  enum class Ground {
    solid,    ///< wall, or a thing of its own
    floor,    ///< where a robot can drive, unless something small stands there
    outdoors  ///< seen through glass only
  };
  struct Stroke {
    Box box;
    Ground ground = Ground::solid;
    int thing = kWall;     ///< solid: position in things()
    int space = kNoSpace;  ///< floor: number of the room; walls are named room by room
  };
  struct Column {
    int x = 0, y = 0, radius = 0;
  };
  /// A leaf or pane across an opening, which no sensor perceives.
  struct Closure {
    Box box;
    std::string type;
  };
  static constexpr int kWall = 0;
  static constexpr int kNoSpace = 0;

  /// Cuts a room, hall or corridor out of the solid.
  void room(const Box& box) { strokes_.push_back({box, Ground::floor, kWall, ++spaces_}); }
  /// Cuts out more of whatever is beside it: a niche, a passage.
  void open(const Box& box) { strokes_.push_back({box, Ground::floor, kWall, kNoSpace}); }
  void wall(const Box& box) { strokes_.push_back({box, Ground::solid, kWall, kNoSpace}); }
  /// A thing with a name of its own that a sensor perceives: "opal:Rack", a shut "opal:Door".
  void thing(const Box& box, const std::string& type);
  /// A round column; stands free on the floor.
  void column(int x, int y, int radius) { columns_.push_back({x, y, radius}); }
  /// Cuts a doorway and hangs its leaf, along its longer side.
  void door(const Box& doorway) { close(doorway, 4, "opal:Door"); }
  /// Cuts an opening between two rooms and glazes it, along its longer side.
  void pane(const Box& opening) { close(opening, 2, "opal:Window"); }
  /// Replaces solid beside the floor by glass, and by outdoors behind it.
  void facade_glass(const Box& beyond) { strokes_.push_back({beyond, Ground::outdoors, kWall, kNoSpace}); }

  const std::vector<Stroke>& strokes() const { return strokes_; }
  const std::vector<std::string>& things() const { return things_; }  ///< types; the first is that of walls
  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<Closure>& closures() const { return closures_; }

 private:
  void close(const Box& opening, int thickness, const std::string& type);

  std::vector<Stroke> strokes_;
  std::vector<std::string> things_{"opal:Wall"};
  std::vector<Column> columns_;
  std::vector<Closure> closures_;
  int spaces_ = kNoSpace;
};

}  // namespace opal::simulation
