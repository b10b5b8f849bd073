#pragma once

#include <opal/common/geometry.hpp>
#include <opal/localization/options/localizer_options.hpp>

#include <optional>

namespace opal {

/// Decides at which scans the map is searched for new hypotheses. Driving and turning bring chances to search; how many
/// chances make one search, the caller says: the surer the robot is, the less there is to find.
class OPAL_EXPORT SearchSchedule {
 public:
  explicit SearchSchedule(const SearchScheduleOptions& options) : options_(options) {}

  /// @param at_once  a chance at this scan, however little the robot has moved
  /// @param every    chances that make one search at least, >= 1
  bool time_to_search(const Pose2& T_odom_base, bool at_once, int every);
  void reset();

 private:
  bool is_chance(const Pose2& T_odom_base) const;

  SearchScheduleOptions options_;
  std::optional<Pose2> T_odom_base_;  ///< at the last chance; none before the first scan
  int chances_passed_ = 0;            ///< since the last search
};

}  // namespace opal
