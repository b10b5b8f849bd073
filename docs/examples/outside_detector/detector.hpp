#pragma once

#include <opal/sensing/feature_detector.hpp>

#include <nlohmann/json.hpp>

#include <span>

/// Finds thin things that stand free: a few returns next to each other, with nothing near behind them on
/// either side.
class PostDetector final : public opal::FeatureDetector {
 public:
  /// @param options  complete and in range: the framework has checked them against plugin.jsonld.
  explicit PostDetector(const nlohmann::json& options);
  std::vector<opal::Feature> detect(const opal::Scan& scan) const override;

 private:
  bool is_post(std::span<const opal::ScanPoint> run, const opal::ScanPoint& before, const opal::ScanPoint& after) const;

  std::size_t min_points_;
  double max_width_m_;
  double clearance_m_;
};
