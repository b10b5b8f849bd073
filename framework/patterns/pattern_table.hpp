#pragma once

#include <opal/patterns/pattern.hpp>

#include <array>
#include <span>
#include <vector>

namespace opal {

/// Patterns of one template in a map, without what only observed ones need. A map has some dozens of them for each
/// feature, so every byte counts: they lie in columns.
class OPAL_EXPORT PatternTable {
 public:
  PatternTable() = default;
  explicit PatternTable(std::span<const PatternInstance> patterns);
  /// Throws PluginError if it has another number of invariants or members than the first one.
  void add(const PatternInstance& pattern);

  std::size_t size() const { return frames_.size(); }
  /// How many numbers describe a pattern; 0 while there is none.
  std::size_t dimensions() const { return dimensions_; }
  Pose2 frame(int number) const {
    const auto& [x_m, y_m, heading_rad] = frames_[number];
    return {x_m, y_m, heading_rad};
  }
  double heading_rad(int number) const { return frames_[number][2]; }  ///< of the frame
  /// In slot order.
  std::span<const int> members(int number) const { return {&members_[number * slots_], slots_}; }
  /// From where to where it extends along the frame's x axis; zeros for patterns that fix the pose.
  std::array<double, 2> extent_m(int number) const {
    return extents_m_.empty() ? std::array<double, 2>{} : extents_m_[number];
  }
  /// Fetches what a search is about to ask: in a large map, it is far away.
  void prefetch(int number) const {
    __builtin_prefetch(&frames_[number]);
    if (!extents_m_.empty()) __builtin_prefetch(&extents_m_[number]);
  }

  /// The numbers that describe all patterns, `dimensions` each; the table is without them afterwards.
  std::vector<float> take_values() { return std::move(values_); }
  void shrink_to_fit();

 private:
  std::size_t dimensions_ = 0, slots_ = 0;
  std::vector<std::array<double, 3>> frames_;     ///< x, y [m], heading [rad]
  std::vector<int> members_;                      ///< slots_ each
  std::vector<std::array<double, 2>> extents_m_;  ///< none while all are zero
  std::vector<float> values_;                     ///< dimensions_ each
};

}  // namespace opal
