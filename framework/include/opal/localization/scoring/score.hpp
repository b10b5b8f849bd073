#pragma once

#include <opal/local_map/local_map.hpp>
#include <opal/localization/scoring/scorer_memory.hpp>
#include <opal/map/map_numbers.hpp>

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
  std::string words;                  ///< "beam 221 passes 1.8 m through opal:Wall wall-12"
  MapFeatureNumber map_feature = {};  ///< none: it is about no feature
  std::vector<Point> line;            ///< where: two points in the `map` frame [m], or empty
};

/// What one laser sees now; base_link frame.
struct ObservedScan {
  Point laser_position = Point::Zero();  ///< where beams start
  std::vector<Point> points = {};        ///< returns, thinned evenly in space by the framework [m]
  /// Directions [rad] that returned nothing up to range_max_m, thinned.
  std::vector<double> free_bearings_rad = {};
  double range_max_m = 0;       ///< how far a beam that returned nothing is known to be free
  std::vector<int> beams = {};  ///< for each of `points`, the number of its beam
  /// For each of `points`, its evidence cell of the local map (LocalMap::evidence_cells): the same for whoever is
  /// judged. Empty: as they are now.
  std::vector<EvidenceCell> evidence_cells = {};
};

/// What hypotheses are judged against: what the robot sees now, with all its lasers.
struct Observation {
  const LocalMap& local_map;            ///< features and pose in the `local` frame, the newest scans included
  std::vector<ObservedScan> scans;      ///< of the lasers that took part
  std::vector<Feature> features = {};   ///< of the newest scans; base_link frame
  std::vector<int> feature_scans = {};  ///< for each of `features`, the position in `scans` of the one that has it;
                                        ///< empty: the first one has all

  /// How many returns the scans have together.
  std::size_t points() const {
    std::size_t sum = 0;
    for (const ObservedScan& scan : scans) sum += scan.points.size();
    return sum;
  }
  /// Where the laser was that saw a feature. @param feature  position in `features`.
  Point viewpoint_of(std::size_t feature) const {
    const std::size_t scan = feature < feature_scans.size() ? static_cast<std::size_t>(feature_scans[feature]) : 0;
    return scan < scans.size() ? scans[scan].laser_position : Point(0, 0);
  }
};

}  // namespace opal
