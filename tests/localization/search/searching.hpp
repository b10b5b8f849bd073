#pragma once

#include "localization/search/global_search.hpp"

#include "tests/localization/synthetic_scene.hpp"

namespace opal::synthetic {

inline const Pose2 kTruth(6.5, 4.2, 0.4);

inline Named<PatternTemplate> corners() { return {"corner", std::make_shared<CornerTemplate>()}; }
inline Named<PatternTemplate> walls() { return {"wall", std::make_shared<WallTemplate>()}; }

/// A search in a map, and a robot there.
struct Searching {
  explicit Searching(const Features& features = room(), const Pose2& T_map_base = kTruth,
                     const SearchOptions& options = {}, std::vector<Named<PatternTemplate>> templates = {corners()})
      : Searching(view_of(features), T_map_base, options, std::move(templates)) {}
  Searching(std::shared_ptr<const MapView> searched, const Pose2& T_map_base, const SearchOptions& options,
            std::vector<Named<PatternTemplate>> templates = {corners()})
      : map(std::move(searched)),
        judges(map, {{"fit", fit_scorer(), ScorerRole::decides, 1}}),
        robot(map, T_map_base),
        search(map, std::move(templates), judges.ensemble, options) {}
  GlobalSearch::Result find(UnderConstrained under_constrained = UnderConstrained::nothing_good,
                            bool keep_rejected = false) const {
    return find(robot.observation(), under_constrained, keep_rejected);
  }
  GlobalSearch::Result find(const Observation& seen, UnderConstrained under_constrained,
                            bool keep_rejected = false) const {
    StageTimes times;
    GlobalSearch::Ongoing ongoing = search.begin({robot.sample(), seen}, under_constrained, times);
    std::optional<GlobalSearch::Result> found;
    while (!found) found = search.go_on(ongoing, {robot.sample(), seen, keep_rejected}, times);
    return *found;
  }
  std::shared_ptr<const MapView> map;
  Judges judges;
  Robot robot;
  GlobalSearch search;
};

inline bool is_at(const VerifiedCandidate& found, const Pose2& pose, double within_m = 0.05, double within_rad = 0.02) {
  return distance_m(found.candidate.T_map_base, pose) < within_m &&
         angle_between_rad(found.candidate.T_map_base, pose) < within_rad;
}

}  // namespace opal::synthetic
