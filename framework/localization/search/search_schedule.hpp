#pragma once

#include <opal/common/geometry.hpp>
#include <opal/localization/options/localizer_options.hpp>

#include <optional>

namespace opal {

/// Decides at which scans the map is searched for new hypotheses. Driving and turning bring chances to search; how many
/// chances make one search, the caller says: the surer the robot is, the less there is to find. A search that had much
/// to look at lets further chances pass, so that time per scan does not grow with the map.
class OPAL_EXPORT SearchSchedule {
 public:
  explicit SearchSchedule(const SearchScheduleOptions& options) : options_(options) {}

  /// @param at_once  a chance at this scan, however little the robot has moved and whatever the last search cost
  /// @param every    chances that make one search at least, >= 1
  bool time_to_search(const Pose2& T_odom_base, bool at_once, int every);
  /// @param expected_places  that the search made last had to look at
  void searched(std::size_t expected_places);
  void reset();

 private:
  bool is_chance(const Pose2& T_odom_base) const;

  SearchScheduleOptions options_;
  std::optional<Pose2> T_odom_base_;  ///< at the last chance; none before the first scan
  int chances_passed_ = 0;            ///< since the last search
  int chances_owed_ = 0;              ///< to let pass for what the last search cost
};

}  // namespace opal
