#pragma once

#include "tests/localization/synthetic_scene.hpp"

#include <opal/localization/localizer.hpp>

namespace opal::synthetic {

using nlohmann::ordered_json;

struct Heard : EventSink {
  std::vector<ordered_json> all;
  bool listening() const override { return true; }
  void write(const ordered_json& event) override { all.push_back(event); }
  std::vector<ordered_json> of(const std::string& kind) const {
    std::vector<ordered_json> some;
    for (const ordered_json& event : all)
      if (event["event"] == kind) some.push_back(event);
    return some;
  }
  /// All of it, without what it cost, and without numbers of things: they go on after a reset.
  std::vector<std::string> said() const {
    std::vector<std::string> lines;
    for (ordered_json event : all) {
      if (event["event"] == "cost") continue;
      drop_numbers(event);
      lines.push_back(event.dump());
    }
    return lines;
  }

 private:
  static void drop_numbers(ordered_json& json) {
    if (json.is_object())
      for (const char* member :
           {"keyframe", "hypothesis", "parent", "merged_into", "local_feature", "pairs", "id", "gone", "reason"})
        json.erase(member);
    if (json.is_object() && json.contains("local_features") && json["local_features"].is_array())
      json.erase("local_features");  // else it is how many there are
    for (ordered_json& inner : json)
      if (inner.is_structured()) drop_numbers(inner);
  }
};

/// Finds what it is told.
struct ToldDetector : FeatureDetector {
  Features features;
  std::vector<Feature> detect(const Scan&) const override { return features; }
};

/// A robot with perfect odometry in the room.
struct Driven {
  std::shared_ptr<const MapView> map = view_of(room());
  std::shared_ptr<ToldDetector> detector = std::make_shared<ToldDetector>();
  Heard heard;
  Localizer localizer;
  double stamp_s = 100;
  Said said;  ///< with the next sample

  explicit Driven(std::shared_ptr<const HypothesisScorer> scorer = fit_scorer(), const LocalizerOptions& options = {})
      : localizer(parts(std::move(scorer), options), &heard) {}

  LocalizerParts parts(std::shared_ptr<const HypothesisScorer> scorer, const LocalizerOptions& options) const {
    LocalizerParts parts;
    parts.map = map;
    parts.lasers[0].T_base_laser = T_base_laser;
    parts.detectors = {{"told", detector}};
    parts.patterns = {{"corner", std::make_shared<CornerTemplate>()}};
    parts.scorers = {{"scorer", std::move(scorer), ScorerRole::decides, 1}};
    parts.stages = options;
    return parts;
  }
  std::optional<PoseEstimate> see_at(const Pose2& T_map_base, const Pose2& T_odom_base) {
    detector->features = detected_from(*map, T_map_base);
    Scan scan = scan_from(*map, T_map_base);
    scan.stamp_s = stamp_s += 0.5;
    Sample sample = sample_of(std::move(scan), T_odom_base, T_base_laser);
    sample.said = std::exchange(said, {});
    return localizer.update(sample);
  }
  std::optional<PoseEstimate> drive_to(const Pose2& T_map_base) { return see_at(T_map_base, T_map_base); }
  /// Keyframe after keyframe across the room.
  void drive_on(int keyframes) {
    for (int k = 0; k < keyframes; ++k) drive_to(Pose2(3 + 0.25 * k, 4.5, 0.1));
  }
  double nat_of(HypothesisId id) const {
    for (const Hypothesis& each : localizer.hypotheses())
      if (each.id == id) return each.log_likelihood;
    return -1e9;
  }
};

}  // namespace opal::synthetic
