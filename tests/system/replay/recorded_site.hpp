#pragma once

#include <opal/deployment/deployment.hpp>
#include <opal/localization/localizer.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include <opal/sensing/replay.hpp>
#include "evaluation/ground_truth.hpp"
#include "evaluation/site.hpp"

#include <memory>
#include <string>
#include <vector>

/// One recorded place below maps/malaga, with what every replay test needs of it.
struct RecordedSite {
  enum class Extent { first_query, whole_log };
  explicit RecordedSite(const std::string& name, Extent extent = Extent::first_query);

  std::shared_ptr<const opal::SemanticMap> map;
  opal::LaserModel laser;
  std::vector<opal::Sample> samples;  ///< of that extent
  opal::GroundTruth truth;

  /// Parts of configs/default.jsonld for another map of the place.
  opal::LocalizerParts parts(std::shared_ptr<const opal::SemanticMap> other_map) const;
  opal::LocalizerParts parts() const { return parts(map); }
};

/// What a replay gave at each scan.
struct ReplayedScan {
  double stamp_s = 0;
  opal::PoseEstimate estimate;
  bool keyframe = false;
};

std::vector<ReplayedScan> replay(opal::Localizer& localizer, const std::vector<opal::Sample>& samples);

/// The same map with everything moved by T_new_map, and its features in another order.
std::shared_ptr<const opal::SemanticMap> moved_map(const opal::SemanticMap& map, const opal::Pose2& T_new_map);
std::shared_ptr<const opal::SemanticMap> reversed_map(const opal::SemanticMap& map);
