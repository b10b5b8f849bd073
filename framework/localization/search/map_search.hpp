#pragma once

#include "localization/search/global_search.hpp"
#include "localization/search/search_schedule.hpp"

namespace opal {

/// Searches the map from scan to scan: when it is time to, for as many scans as it takes, and where a hint says.
class OPAL_EXPORT MapSearch {
 public:
  MapSearch(const GlobalSearch& search, const SearchScheduleOptions& schedule) : search_(search), schedule_(schedule) {}

  /// To be looked at with the next scan. One that is not finite says nothing.
  void hint(const PoseHint& hint);
  bool has_hint() const { return hint_.has_value(); }

  /// What is known about the robot.
  struct Need {
    bool at_once = false;  ///< however little the robot has moved
    bool anew = false;     ///< the robot is elsewhere than when a search began that is still under way
    int every = 1;         ///< chances that make one search
    UnderConstrained under_constrained = UnderConstrained::never;  ///< where such patterns are looked up, too
  };
  /// @param scene  scans that no call has had yet.
  /// @return what is found with this scan; searches that are not through find nothing yet.
  std::vector<GlobalSearch::Result> look(const GlobalSearch::Scene& scene, const Pose2& T_odom_base, const Need& need,
                                         StageTimes& times);

  /// What was seen no longer tells where the robot is.
  void abandon() { ongoing_.reset(); }
  /// The same, and the next scan is the first one; a hint stays.
  void restart();
  void forget_hint() { hint_.reset(); }

 private:
  const GlobalSearch& search_;
  SearchSchedule schedule_;
  std::optional<PoseHint> hint_;
  std::optional<GlobalSearch::Ongoing> ongoing_;
};

}  // namespace opal
