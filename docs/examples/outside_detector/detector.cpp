#include "detector.hpp"

#include <algorithm>

namespace {

constexpr double kRangeSigma_m = 0.02;

opal::Feature post_at(std::span<const opal::ScanPoint> run) {
  opal::Point sum = opal::Point::Zero();
  for (const opal::ScanPoint& point : run) sum += point.position;
  const double width_m = (run.back().position - run.front().position).norm();
  opal::Feature post;
  post.type = "acme:Post";
  post.geometry = opal::Point(sum / static_cast<double>(run.size()));
  // What was seen is the front of the post: its axis is within a width of there.
  const double variance = kRangeSigma_m * kRangeSigma_m + width_m * width_m / 4;
  post.covariance.topLeftCorner<2, 2>() = variance * Eigen::Matrix2d::Identity();
  return post;
}

}  // namespace

PostDetector::PostDetector(const nlohmann::json& options)
    : min_points_(options.at("min_points")),
      max_width_m_(options.at("max_width_m")),
      clearance_m_(options.at("clearance_m")) {}

std::vector<opal::Feature> PostDetector::detect(const opal::Scan& scan) const {
  std::vector<opal::ScanPoint> points;
  std::copy_if(scan.points.begin(), scan.points.end(), std::back_inserter(points),
               [](const opal::ScanPoint& point) { return point.position.allFinite(); });
  std::vector<opal::Feature> posts;
  std::size_t begin = 0;
  for (std::size_t end = 1; end < points.size(); ++end) {
    if ((points[end].position - points[end - 1].position).norm() <= clearance_m_) continue;
    const auto run = std::span(points).subspan(begin, end - begin);
    if (begin > 0 && is_post(run, points[begin - 1], points[end])) posts.push_back(post_at(run));
    begin = end;
  }
  return posts;
}

bool PostDetector::is_post(std::span<const opal::ScanPoint> run, const opal::ScanPoint& before,
                           const opal::ScanPoint& after) const {
  const double width_m = (run.back().position - run.front().position).norm();
  return run.size() >= min_points_ && width_m <= max_width_m_ && before.range_m > run.front().range_m + clearance_m_ &&
         after.range_m > run.back().range_m + clearance_m_;
}
