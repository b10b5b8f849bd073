#include "cli/track/start_poses.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <sstream>

namespace opal::cli {
namespace {

constexpr double kMostHeading_rad = 2 * std::numbers::pi;  // more is a heading in degrees

/// Numbers between commas; empty if something is no finite number.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    std::size_t used = 0;
    try {
      numbers.push_back(std::stod(word, &used));
    } catch (const std::exception&) {
      return {};
    }
    if (used != word.size() || !std::isfinite(numbers.back())) return {};
  }
  return text.ends_with(',') ? std::vector<double>{} : numbers;
}

}  // namespace

Pose2 read_pose(const std::string& text) {
  const std::vector<double> n = numbers_of(text);
  if (n.size() != 3) throw ConfigError("--pose: '" + text + "', expected X,Y,THETA in metres and radians");
  if (std::abs(n[2]) > kMostHeading_rad)
    throw ConfigError(fmt::format("--pose: heading {:g}, expected radians from -2 pi to 2 pi; {:g} degrees are {:.3f}",
                                  n[2], n[2], radians(n[2])));
  return {n[0], n[1], n[2]};
}

Disturbance read_disturbance(const std::string& text) {
  const std::vector<double> n = numbers_of(text);
  if (n.size() != 2 || n[0] < 0 || n[1] < 0)
    throw ConfigError("--disturb: '" + text + "', expected METRES,RADIANS, neither negative");
  return {n[0], n[1]};
}

StartAt StartPoses::next() {
  const auto uniform = [&] { return std::uniform_real_distribution<double>(-1, 1)(random_); };
  const double dx = uniform() * disturbance_.position_m, dy = uniform() * disturbance_.position_m;
  const double turn = uniform() * disturbance_.heading_rad;
  constexpr double kTruthSigma_m = 0.05, kTruthSigma_rad = 0.03;
  const Eigen::Vector3d sigma(kTruthSigma_m + disturbance_.position_m, kTruthSigma_m + disturbance_.position_m,
                              kTruthSigma_rad + disturbance_.heading_rad);
  return [=, this](double stamp_s) -> std::optional<StartPose> {
    const auto T_map_laser = truth_.T_map_laser_at(stamp_s);
    if (!T_map_laser) return std::nullopt;
    const Pose2 T_map_base = *T_map_laser * T_base_laser_.inverse();
    return StartPose{{T_map_base.x() + dx, T_map_base.y() + dy, T_map_base.heading_rad() + turn}, sigma};
  };
}

}  // namespace opal::cli
