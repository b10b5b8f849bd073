#include <opal/import_kit/far_origin.hpp>

#include <fmt/format.h>

namespace opal {
namespace {

constexpr double kFarPlan_m = 1e6;
constexpr double kLargestFarPlan_m = 1e4;
constexpr double kFarRounding_m = 1000;

}  // namespace

Point origin_of_far_plan(const Point& low_m, const Point& high_m) {
  const double farthest_m = low_m.cwiseAbs().cwiseMax(high_m.cwiseAbs()).maxCoeff();
  const bool is_building = low_m.allFinite() && high_m.allFinite() && (high_m - low_m).maxCoeff() < kLargestFarPlan_m;
  if (!(farthest_m > kFarPlan_m) || !is_building) return Point::Zero();
  return kFarRounding_m * (low_m / kFarRounding_m).array().floor().matrix();
}

std::string sentence_about_far_origin(const Point& origin_m) {
  return fmt::format(
      "the plan lies farther than 1000 km from its origin: the map's origin is at {:.0f}, {:.0f} m of the plan "
      "(--set origin_x_m and origin_y_m choose another)",
      origin_m.x(), origin_m.y());
}

}  // namespace opal
