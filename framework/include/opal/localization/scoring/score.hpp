#pragma once

#include <opal/local_map/local_map.hpp>
#include <opal/localization/scoring/scorer_memory.hpp>

#include <memory>
#include <string>
#include <vector>

namespace opal {

/// A scorer's opinion of one hypothesis. Opinions of several scorers add up; score and veto are separate.
struct Score {
  double log_likelihood = 0;  ///< contribution of this scan [nat]; > 0 speaks for the hypothesis
  std::string veto;           ///< not empty: the hypothesis must not survive, and this is why
  /// One summand, or a number that explains the score.
  struct Term {
    std::string name;  ///< the scorer's own word for it
    double value = 0;  ///< in the unit that the name says; [nat] without one
  };
  std::vector<Term> breakdown;                    ///< what it is made of, for people and for A/B records
  std::shared_ptr<const ScorerMemory> seen = {};  ///< what this scan adds to the scorer's memory; null: nothing
};

/// One thing that a scorer saw for or against a hypothesis, for people.
struct Finding {
  std::string words;        ///< "beam 221 passes 1.8 m through opal:Wall wall-12"
  int map_feature = -1;     ///< position in SemanticMap::features(); -1: none
  std::vector<Point> line;  ///< where: two points in the `map` frame [m], or empty
};

/// What hypotheses are judged against: what the robot sees now.
struct Observation {
  const LocalMap& local_map;  ///< features and pose in the `local` frame, the newest scan included
  /// Returns of the newest scan, thinned evenly in space by the framework; base_link frame [m].
  std::vector<Point> points;
  /// Directions [rad, base_link] that returned nothing up to range_max_m, thinned.
  std::vector<double> free_bearings_rad;
  double range_max_m = 0;                ///< how far a beam that returned nothing is known to be free
  Point laser_position = Point::Zero();  ///< where beams start, base_link frame
  /// Features of the newest scan, base_link frame.
  std::vector<Feature> features;
  /// For each of `points`, the number of its beam.
  std::vector<int> beams = {};
  /// For each of `points`, its evidence cell of the local map (LocalMap::evidence_cells): the same for whoever is
  /// judged. Empty: as they are now.
  std::vector<int> evidence_cells = {};
};

}  // namespace opal
