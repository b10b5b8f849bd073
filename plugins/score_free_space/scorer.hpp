#pragma once

#include "free_room.hpp"

#include <opal/localization/scoring/hypothesis_scorer.hpp>
#include <opal/sensing/free_space.hpp>

#include <nlohmann/json.hpp>

#include <memory>
#include <set>
#include <string>

namespace opal::score_free_space {

/// Absence of expected geometry (Hendrikx 2023, 4.3.6): what the map has inside the room that the scan shows to be
/// empty speaks against a hypothesis. Beams that end early leave less room, and say nothing else. Things that move
/// (doors) or that a laser looks through (windows) are no evidence, nor is what the sensor does not perceive.
class FreeSpaceScorer final : public HypothesisScorer {
 public:
  explicit FreeSpaceScorer(const nlohmann::json& options);
  ~FreeSpaceScorer() override;
  Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
              const ScorerMemory*) const override;
  bool judges_associations() const override { return false; }
  /// The mapped objects that reach deepest into free space.
  std::vector<Finding> explain(const Hypothesis& hypothesis, const Observation& observation,
                               const MapView& map) const override;

 private:
  struct Overlap {
    MapFeatureNumber map_feature = {};
    double length_m = 0;
    Segment longest;  ///< its longest part, base_link frame
  };
  /// The free room of one scan, and where its laser is; base_link frame.
  struct ScanRoom {
    FreeRoom room;
    Point laser_position;
  };
  std::vector<Overlap> overlaps(const Pose2& T_map_base, const Observation& observation, const MapView& map) const;
  std::vector<Overlap> overlaps(const Pose2& T_map_base, const ScanRoom& seen, const MapView& map) const;
  Overlap overlap_of(const FreeRoom& room, const Pose2& T_base_map, const Point& eye, MapFeatureNumber number,
                     const MapView& map) const;
  double margin_for(const Observation& observation) const;
  /// The same observation is asked about for every hypothesis, so its polygons are kept.
  const std::vector<ScanRoom>& rooms_of(const Observation& observation) const;

  FreeSpaceOptions outline_;
  double margin_m_, sigmas_, unmatched_m_, weight_nat_per_m_, most_m_, veto_m_;
  std::set<std::string> no_evidence_;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace opal::score_free_space
