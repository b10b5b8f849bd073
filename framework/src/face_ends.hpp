#pragma once

#include <opal/map_view.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace opal {

/// Ends of mapped faces by place, in cells of 2 m: a lookup costs the same however large the map is.
class FaceEnds {
 public:
  struct End {
    Point position;
    Point direction;  ///< of its face, unit
    int face = -1;    ///< feature number
    Tip tip = Tip::begin;
  };

  FaceEnds() = default;
  explicit FaceEnds(std::vector<End> ends);
  FaceEnd nearest(const Point& p, const Point& direction, Tip tip, const EndGate& gate) const;

 private:
  struct Range {
    std::size_t begin = 0, end = 0;
  };
  std::vector<End> ends_;  ///< those of one cell together
  std::unordered_map<std::int64_t, Range> cells_;
};

}  // namespace opal
