#pragma once

#include "common/prepared/read_only_array.hpp"

#include <opal/patterns/pattern.hpp>

#include <array>
#include <span>
#include <vector>

namespace opal {

/// Patterns of one template as they are found, without what only observed ones need. A map has some dozens of them for
/// each feature, so every byte counts: they lie in columns.
class OPAL_EXPORT PatternList {
 public:
  PatternList() = default;
  explicit PatternList(std::span<const PatternInstance> patterns);
  /// Throws PluginError if it has another number of invariants or members than the first one.
  void add(const PatternInstance& pattern);

  std::size_t size() const { return frames_.size(); }
  /// How many numbers describe a pattern; 0 while there is none.
  std::size_t dimensions() const { return dimensions_; }
  /// The numbers that describe all patterns, `dimensions` each; the list is without them afterwards.
  std::vector<float> take_values() { return std::move(values_); }

 private:
  friend class PatternTable;

  std::size_t dimensions_ = 0, slots_ = 0;
  std::vector<std::array<double, 3>> frames_;
  std::vector<int> members_;
  std::vector<std::array<double, 2>> extents_m_;
  std::vector<float> values_;  ///< dimensions_ each
};

/// Patterns of one template in a map, without the numbers that describe them. Immutable.
class OPAL_EXPORT PatternTable {
 public:
  /// All that a table is, side by side.
  struct Columns {
    std::size_t slots = 0;
    ReadOnlyArray<std::array<double, 3>> frames;     ///< x, y [m], heading [rad]
    ReadOnlyArray<int> members;                      ///< `slots` each
    ReadOnlyArray<std::array<double, 2>> extents_m;  ///< none while all are zero
  };

  explicit PatternTable(Columns columns) : columns_(std::move(columns)) {}
  explicit PatternTable(PatternList patterns);

  const Columns& columns() const { return columns_; }
  std::size_t size() const { return columns_.frames.size(); }
  Pose2 frame(int number) const {
    const auto& [x_m, y_m, heading_rad] = columns_.frames[number];
    return {x_m, y_m, heading_rad};
  }
  double heading_rad(int number) const { return columns_.frames[number][2]; }  ///< of the frame
  /// In slot order.
  std::span<const int> members(int number) const {
    return columns_.members.values().subspan(number * columns_.slots, columns_.slots);
  }
  /// From where to where it extends along the frame's x axis; zeros for patterns that fix the pose.
  std::array<double, 2> extent_m(int number) const {
    return columns_.extents_m.size() == 0 ? std::array<double, 2>{} : columns_.extents_m[number];
  }
  /// Fetches what a search is about to ask: in a large map, it is far away.
  void prefetch(int number) const {
    __builtin_prefetch(&columns_.frames[number]);
    if (columns_.extents_m.size() > 0) __builtin_prefetch(&columns_.extents_m[number]);
  }

 private:
  Columns columns_;
};

}  // namespace opal
