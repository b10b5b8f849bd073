#include "ros2/pose_hint.hpp"

#include "recording/wire_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace opal::ros2 {
namespace {

// What "2D Pose Estimate" of RViz sends.
constexpr double kRvizSigmaM = 0.5;
constexpr double kRvizSigmaRad = 0.26;
constexpr std::size_t kCovarianceX = 0, kCovarianceY = 7, kCovarianceHeading = 35;

double sigma_of(double variance, double otherwise) {
  return std::isfinite(variance) && variance > 0 ? std::sqrt(variance) : otherwise;
}

}  // namespace

std::optional<FramedHint> decode_pose_hint(recording::Bytes message) {
  recording::WireReader wire(message, recording::Wire::cdr);
  wire.skip_numbers(2, sizeof(std::uint32_t));
  FramedHint framed;
  framed.frame = recording::without_slash(wire.text());
  double pose[7], covariance[36];
  for (double& value : pose) value = wire.number<double>();
  for (double& value : covariance) value = wire.number<double>();
  const double x = pose[3], y = pose[4], z = pose[5], w = pose[6];
  const double norm = std::sqrt(x * x + y * y + z * z + w * w);
  const bool is_pose = std::isfinite(pose[0]) && std::isfinite(pose[1]) && norm > 0.5 && norm < 2;
  if (!wire.ok() || !is_pose) return std::nullopt;
  framed.hint.T_map_base = Pose2(pose[0], pose[1], std::atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z));
  framed.hint.sigma_m = sigma_of(std::max(covariance[kCovarianceX], covariance[kCovarianceY]), kRvizSigmaM);
  framed.hint.sigma_rad = sigma_of(covariance[kCovarianceHeading], kRvizSigmaRad);
  return framed;
}

std::optional<double> decode_clock(recording::Bytes message) {
  recording::WireReader wire(message, recording::Wire::cdr);
  const auto seconds = wire.number<std::int32_t>();
  const auto nanoseconds = wire.number<std::uint32_t>();
  if (!wire.ok()) return std::nullopt;
  return seconds + 1e-9 * nanoseconds;
}

std::string usual_odometry(const std::vector<Offer>& offers) {
  std::set<std::string> topics;
  for (const Offer& offer : offers)
    if (offer.type == "nav_msgs/msg/Odometry") topics.insert(offer.topic);
  if (topics.contains("/odom")) return "/odom";
  return topics.size() == 1 ? *topics.begin() : "";
}

}  // namespace opal::ros2
