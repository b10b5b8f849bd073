#pragma once

#include <opal/common/feature.hpp>

#include <map>
#include <utility>
#include <vector>

namespace opal {

/// One thing of the building as a detector sees it from several places. Frame: `map`.
struct Sighted {
  std::string type;
  std::vector<Geometry> views;  ///< as seen from each place, in the order of the places
  double farthest_m = 0;        ///< from where it was seen

  /// The middle of all views: medians of its numbers; of segments the longest view.
  Geometry geometry() const;
};

/// Sorts what a detector sees by the things that it belongs to.
class Sightings {
 public:
  /// @param seen  frame `map`. @param from  the place it was seen from, `map`.
  void add(const Feature& seen, const Point& from);
  /// In the order in which they were first seen.
  const std::vector<Sighted>& all() const { return all_; }

 private:
  using Cell = std::pair<int, int>;
  static Cell cell_of(const Point& place);
  Sighted* same(const Feature& seen);

  std::vector<Sighted> all_;
  std::map<Cell, std::vector<std::size_t>> by_cell_;  ///< positions in all_, by the anchor of the first view
};

/// Whether two geometries of one kind are views of one thing: near to each other, and turned alike. Segments of one
/// straight face are, whatever part of it they show.
bool is_one_thing(const Geometry& a, const Geometry& b);

}  // namespace opal
