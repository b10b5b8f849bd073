#pragma once

#include <opal/recording/recording.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace opal::recording {

/// Where one number of each point lies (sensor_msgs/PointField).
struct PointField {
  std::string name;        ///< "x"
  std::size_t offset = 0;  ///< from the start of a point [byte]
  static constexpr int kUint32 = 6, kFloat32 = 7, kFloat64 = 8;
  int datatype = 0;  ///< 1 to 8: INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64

  /// "x FLOAT32"
  std::string words() const;
};

/// sensor_msgs/PointCloud2. Its points are those of the message, which must outlive it.
class PointCloudMessage {
 public:
  /// One point, in the sensor's frame, as it was sent: it need not be finite.
  struct CloudPoint {
    double x_m = 0, y_m = 0, z_m = 0;
    double time = 0;  ///< as the message has it; 0 without such a field

    /// Drivers write NaN, infinity or zeros for a beam that has met nothing.
    bool is_measured() const {
      constexpr double kFarthest_m = 1e6;  // damaged numbers are larger
      return std::abs(x_m) < kFarthest_m && std::abs(y_m) < kFarthest_m && std::abs(z_m) < kFarthest_m &&
             (x_m != 0 || y_m != 0 || z_m != 0);
    }
  };

  double stamp_s = 0;              ///< 0: never set
  std::string frame;               ///< of the sensor
  std::size_t width = 0;           ///< points in a row
  std::size_t height = 0;          ///< rows
  std::vector<PointField> fields;  ///< all, in their order

  std::size_t size() const { return width * height; }
  /// @param index  below `size`.
  CloudPoint point(std::size_t index) const {
    return point_at(index / width * row_step_ + index % width * point_step_);
  }
  /// Calls `take` with each point, row by row.
  template <class Take>
  void for_each_point(Take take) const {
    for_each_place([&](std::size_t at) { take(point_at(at)); });
  }
  /// The least and the greatest of their times; the first is greater than the last if there is none.
  std::pair<double, double> time_range() const;
  /// When points were measured; null if the message does not state it in a way that is known.
  const PointField* time_field() const { return has_time() ? &fields[time_] : nullptr; }

 private:
  friend struct PointCloudDecoder;

  bool has_time() const { return time_ < fields.size(); }

  // Every number of a hundred thousand points is read here: to be compiled where it is used.
  template <class Take>
  void for_each_place(Take take) const {
    if (width == 0) return;  // there may be billions of empty rows
    for (std::size_t row = 0; row < height; ++row)
      for (std::size_t k = 0; k < width; ++k) take(row * row_step_ + k * point_step_);
  }
  template <class Number>
  double number_of(std::size_t at) const {
    std::byte bytes[sizeof(Number)];
    std::memcpy(bytes, data_.data() + at, sizeof(Number));
    if (swap_) std::reverse(bytes, bytes + sizeof(Number));
    Number value;
    std::memcpy(&value, bytes, sizeof(Number));
    return static_cast<double>(value);
  }
  double number_at(std::size_t at, const PointField& field) const {
    if (field.datatype == PointField::kFloat32) return number_of<float>(at + field.offset);
    if (field.datatype == PointField::kFloat64) return number_of<double>(at + field.offset);
    return number_of<std::uint32_t>(at + field.offset);
  }
  CloudPoint point_at(std::size_t at) const {
    const double time = has_time() ? number_at(at, fields[time_]) : 0;
    return {number_at(at, fields[xyz_[0]]), number_at(at, fields[xyz_[1]]), number_at(at, fields[xyz_[2]]), time};
  }

  std::size_t point_step_ = 0, row_step_ = 0;
  bool swap_ = false;
  Bytes data_;
  std::array<std::size_t, 3> xyz_{};                            // in `fields`
  std::size_t time_ = std::numeric_limits<std::size_t>::max();  // the same; beyond the end: none
};

/// A message, or why there is none.
struct DecodedPointCloud {
  std::optional<PointCloudMessage> cloud;
  std::string complaint;  ///< without numbers, so that it can be counted: "PointCloud2 message without x, y and z"
};

DecodedPointCloud decode_point_cloud(Bytes message, Wire wire);

/// Seconds from the stamp of a cloud to its points. Drivers write them in different units: nanoseconds since the stamp
/// (Ouster: t), seconds since the stamp (Velodyne: time), seconds, microseconds or nanoseconds since 1970 (Hesai,
/// Livox: timestamp). That one is taken by which the points lie nearest to the stamp, within a second.
class PointTimes {
 public:
  explicit PointTimes(const PointCloudMessage& cloud);
  /// Whether the points were measured one after the other, and when.
  bool are_known() const { return unit_s_ > 0; }
  /// @param time  CloudPoint::time.
  double after_stamp_s(double time) const { return (time - zero_) * unit_s_; }
  /// From the first point to the last.
  double span_s() const { return (last_ - first_) * unit_s_; }

 private:
  double first_ = 0, last_ = 0;  // as the message has them
  double zero_ = 0;              // what stands for the stamp
  double unit_s_ = 0;
};

}  // namespace opal::recording
