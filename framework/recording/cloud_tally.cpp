#include "recording/cloud_tally.hpp"

#include <algorithm>

namespace opal::recording {
namespace {

constexpr std::size_t kPointsOfACloud = 2000;
// What stands on the floor begins there, and what hangs from the ceiling ends there; a band has to be so high.
constexpr double kFromFloor_m = 0.3, kFromCeiling_m = 0.3, kHighest_m = 2, kLeastBand_m = 0.2;
// One point in a hundred may be a reflection.
constexpr double kOdd = 0.01;
// Floor and ceiling are hit by more points than this.
constexpr double kFloorShare = 0.05;

/// @param share  0: the least of the values, 1: the greatest. @param values  at least one.
double quantile_of(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

std::vector<double> coordinates(const std::vector<Eigen::Vector3d>& points, int axis) {
  std::vector<double> values;
  for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
  return values;
}

/// Above what most likely is the floor, below what most likely is the ceiling, and not above a person.
CloudSlice suggested_slice(const std::vector<double>& heights_m) {
  const double floor_m = quantile_of(heights_m, kFloorShare), ceiling_m = quantile_of(heights_m, 1 - kFloorShare);
  CloudSlice slice;
  slice.z_min_m = floor_m + kFromFloor_m;
  slice.z_max_m = std::min(ceiling_m - kFromCeiling_m, floor_m + kHighest_m);
  if (slice.z_max_m - slice.z_min_m >= kLeastBand_m) return slice;
  slice.z_min_m = floor_m - kLeastBand_m;  // a lidar of a few rings, whose points are at one height
  slice.z_max_m = ceiling_m + kLeastBand_m;
  return slice;
}

}  // namespace

void CloudTally::add(const PointCloudMessage& cloud) {
  if (cloud_.clouds++ == 0) {
    cloud_.frame = cloud.frame;
    cloud_.width = static_cast<std::int64_t>(cloud.width);
    cloud_.height = static_cast<std::int64_t>(cloud.height);
    for (const PointField& field : cloud.fields) cloud_.fields.push_back(field.words());
    const PointTimes times(cloud);
    if (times.are_known()) cloud_.time_field = cloud.time_field()->name;
    if (times.are_known()) cloud_.sweep_s = times.span_s();
  }
  const std::size_t step = 1 + cloud.size() / kPointsOfACloud;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    const PointCloudMessage::CloudPoint point = cloud.point(i);
    ++looked_at_;
    if (point.is_measured()) points_.emplace_back(point.x_m, point.y_m, point.z_m);
  }
}

LogCloud CloudTally::told(const std::string& topic, const std::optional<Eigen::Isometry3d>& T_base_sensor) const {
  LogCloud told = cloud_;
  told.topic = topic;
  if (points_.empty()) return told;
  told.valid_share = static_cast<double>(points_.size()) / looked_at_;
  const Eigen::Isometry3d T = T_base_sensor.value_or(Eigen::Isometry3d::Identity());
  std::vector<Eigen::Vector3d> points;
  std::vector<double> ranges_m;
  for (const Eigen::Vector3d& point : points_) {
    points.push_back(T * point);
    ranges_m.push_back((points.back() - T.translation()).head<2>().norm());
  }
  const std::vector<double> x = coordinates(points, 0), y = coordinates(points, 1), z = coordinates(points, 2);
  told.x_min_m = quantile_of(x, kOdd), told.x_max_m = quantile_of(x, 1 - kOdd);
  told.y_min_m = quantile_of(y, kOdd), told.y_max_m = quantile_of(y, 1 - kOdd);
  told.z_min_m = quantile_of(z, kOdd), told.z_max_m = quantile_of(z, 1 - kOdd);
  told.farthest_m = quantile_of(ranges_m, 1 - kOdd);
  told.suggested = suggested_slice(z);
  return told;
}

std::map<std::string, CloudTally> tally_clouds(const Parts& parts, Defects& defects) {
  std::map<std::string, CloudTally> tallies;
  for (const std::string& topic : cloud_topics(parts)) {
    CloudTally& tally = tallies[topic];
    for (const auto& part : parts) {
      const auto walk = part->walk(topics_where(*part, is_named(topic)));
      while (!tally.is_full()) {
        const auto message = walk->next();
        if (!message) break;
        const DecodedPointCloud decoded = decode_point_cloud(message->data, part->topics()[message->topic].wire);
        if (decoded.cloud) tally.add(*decoded.cloud);
        if (!decoded.cloud) ++defects[decoded.complaint];
      }
    }
  }
  return tallies;
}

}  // namespace opal::recording
