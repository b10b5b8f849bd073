#include "benchmark/runs/run_picture.hpp"

#include "benchmark/runs/answer.hpp"

#include <fmt/format.h>

#include <cmath>

namespace opal::benchmark {
namespace {

/// A wider gap between two returns is not known to be free.
constexpr double kWidestGap_rad = 0.1;

/// The fan of beams that hit something, laser frame.
std::vector<opal::Point> seen_free(const std::vector<opal::Point>& points) {
  std::vector<opal::Point> outline;
  double before_rad = -10;
  for (const opal::Point& point : points) {
    const double bearing_rad = std::atan2(point.y(), point.x());
    if (bearing_rad - before_rad > kWidestGap_rad) outline.push_back(opal::Point::Zero());
    outline.push_back(point);
    before_rad = bearing_rad;
  }
  return outline;
}

std::vector<opal::Point> moved(const opal::Pose2& T_to_from, std::vector<opal::Point> points) {
  for (opal::Point& point : points) point = T_to_from * point;
  return points;
}

/// Best first, each as probable as its evidence says relative to the best.
std::vector<opal::DrawingScene::DrawnHypothesis> drawn_hypotheses(const opal::Localizer& localizer,
                                                                  const opal::PoseEstimate& estimate) {
  std::vector<opal::DrawingScene::DrawnHypothesis> drawn;
  const std::vector<opal::Hypothesis> alive = localizer.hypotheses();
  for (const opal::Hypothesis& hypothesis : alive) {
    const double odds = std::exp(hypothesis.log_likelihood - alive.front().log_likelihood);
    drawn.push_back({hypothesis.T_map_local * localizer.local_map().T_local_base(), odds * estimate.probability});
  }
  return drawn;
}

std::string status_text(const opal::PoseEstimate& estimate) {
  const std::string status = opal::name_of(estimate.status);
  return status + (estimate.has_pose ? fmt::format(", probability {:.3f}", estimate.probability) : ", no hypothesis");
}

void add_best(opal::DrawingScene& scene, const opal::Localizer& localizer, const opal::LaserModel& laser,
              const RunRecord& record) {
  const opal::Pose2 T_map_local = localizer.hypotheses().front().T_map_local;
  const opal::Pose2 T_map_laser = T_map_local * localizer.local_map().T_local_base() * laser.T_base_laser;
  scene.scan_points = moved(T_map_laser, record.last_points);
  scene.free_space = moved(T_map_laser, seen_free(record.last_points));
  for (const opal::LocalFeature& local : localizer.local_map().features())
    if (local.stable) scene.local_features.push_back({transformed(T_map_local, local.feature.geometry)});
  for (const NamedAssociation& named : associations_of(localizer))
    scene.associations.push_back({named.local, named.mapped});
  scene.notes.push_back(place_words(localizer, record.last.T_map_base));
  if (const opal::MapStorey* storey = storey_at(localizer.map().map(), record.last.T_map_base.position())) {
    constexpr double kMargin_m = 2;  // a picture shows one sheet
    const opal::Point margin = opal::Point::Constant(kMargin_m);
    scene.view = {opal::Point(storey->bounds[0] - margin), opal::Point(storey->bounds[1] + margin)};
  }
}

}  // namespace

opal::DrawingScene scene_of(const opal::Localizer& localizer, const opal::LaserModel& laser, const RunRecord& record) {
  opal::DrawingScene scene;
  // The scene does not outlive the localizer, which keeps the map.
  scene.map = std::shared_ptr<const opal::SemanticMap>(std::shared_ptr<void>(), &localizer.map().map());
  scene.notes.push_back(status_text(record.last));
  scene.hypotheses = drawn_hypotheses(localizer, record.last);
  if (!scene.hypotheses.empty()) add_best(scene, localizer, laser, record);
  // What was guessed before is no path that was driven. Rows and poses are of the same scans.
  for (std::size_t k = 0; k < record.trajectory.size(); ++k)
    if (record.rows[k].localized()) scene.trajectory.push_back(record.trajectory[k].pose.position());
  return scene;
}

void add_truth(opal::DrawingScene& scene, const std::vector<opal::StampedPose>& T_map_laser,
               const opal::LaserModel& laser) {
  const opal::Pose2 T_laser_base = laser.T_base_laser.inverse();
  for (const opal::StampedPose& pose : T_map_laser) scene.truth.push_back((pose.pose * T_laser_base).position());
}

}  // namespace opal::benchmark
