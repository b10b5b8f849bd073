#pragma once

#include "free_room.hpp"

#include <opal/localization/scoring/hypothesis_scorer.hpp>
#include <opal/sensing/free_space.hpp>

#include <nlohmann/json.hpp>

#include <memory>
#include <set>
#include <string>

/// Absence of expected geometry (Hendrikx 2023, 4.3.6): what the map has inside the room that the scan shows to be
/// empty speaks against a hypothesis. Beams that end early leave less room, and say nothing else. Things that move
/// (doors) or that a laser looks through (windows) are no evidence, nor is what the sensor does not perceive.
class FreeSpaceScorer final : public opal::HypothesisScorer {
 public:
  explicit FreeSpaceScorer(const nlohmann::json& options);
  ~FreeSpaceScorer() override;
  opal::Score score(const opal::Hypothesis& hypothesis, const opal::Observation& observation, const opal::MapView& map,
                    const opal::ScorerMemory*) const override;
  bool judges_associations() const override { return false; }
  /// The mapped objects that reach deepest into free space.
  std::vector<opal::Finding> explain(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                     const opal::MapView& map) const override;

 private:
  struct Overlap {
    opal::MapFeatureNumber map_feature = {};
    double length_m = 0;
    opal::Segment longest;  ///< its longest part, base_link frame
  };
  /// The free room of one scan, and where its laser is; base_link frame.
  struct ScanRoom {
    FreeRoom room;
    opal::Point laser_position;
  };
  std::vector<Overlap> overlaps(const opal::Pose2& T_map_base, const opal::Observation& observation,
                                const opal::MapView& map) const;
  std::vector<Overlap> overlaps(const opal::Pose2& T_map_base, const ScanRoom& seen, const opal::MapView& map) const;
  Overlap overlap_of(const FreeRoom& room, const opal::Pose2& T_base_map, const opal::Point& eye,
                     opal::MapFeatureNumber number, const opal::MapView& map) const;
  double margin_for(const opal::Observation& observation) const;
  /// The same observation is asked about for every hypothesis, so its polygons are kept.
  const std::vector<ScanRoom>& rooms_of(const opal::Observation& observation) const;

  opal::FreeSpaceOptions outline_;
  double margin_m_, sigmas_, unmatched_m_, weight_nat_per_m_, most_m_, veto_m_;
  std::set<std::string> no_evidence_;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};
