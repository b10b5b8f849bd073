#include "recording/point_cloud.hpp"

#include "recording/wire_reader.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace opal::recording {
namespace {

constexpr std::size_t kMostPoints = 4'000'000;  // 128 rings at 0.01 degrees are 4.6 million; drivers send a tenth of it
constexpr std::size_t kLeastFieldBytes = 13;    // an empty name, offset, datatype, count
constexpr double kLeastSweep_s = 1e-3, kMostSweep_s = 1;  // what takes less is as good as all at once

struct PointType {
  const char* name;
  std::size_t bytes;
};
constexpr std::array<PointType, 9> kTypes{{{"of no type", 0},
                                           {"INT8", 1},
                                           {"UINT8", 1},
                                           {"INT16", 2},
                                           {"UINT16", 2},
                                           {"INT32", 4},
                                           {"UINT32", 4},
                                           {"FLOAT32", 4},
                                           {"FLOAT64", 8}}};

bool is_real(const PointField& field) {
  return field.datatype == PointField::kFloat32 || field.datatype == PointField::kFloat64;
}

bool is_time(const PointField& field) {
  static const std::array<const char*, 7> kNames{"t",     "time",      "timestamp",  "time_stamp",
                                                 "stamp", "timeStamp", "offset_time"};
  const bool is_named = std::find(kNames.begin(), kNames.end(), field.name) != kNames.end();
  return is_named && (is_real(field) || field.datatype == PointField::kUint32);
}

bool lies_in_point(const PointField& field, std::size_t point_step) {
  const std::size_t bytes = kTypes[static_cast<std::size_t>(field.datatype)].bytes;
  return bytes <= point_step && field.offset <= point_step - bytes;
}

/// How the times of points may be meant.
struct Reading {
  double unit_s;
  double zero;  // what stands for the stamp
};

std::vector<Reading> readings_of(const PointField& time, double stamp_s) {
  constexpr double kNano = 1e-9, kMicro = 1e-6;
  if (time.datatype == PointField::kUint32) return {{kNano, 0}, {kMicro, 0}};
  return {{1, 0}, {1, stamp_s}, {kMicro, stamp_s / kMicro}, {kNano, stamp_s / kNano}, {kNano, 0}};
}

}  // namespace

std::string PointField::words() const {
  const bool is_known = datatype > 0 && static_cast<std::size_t>(datatype) < kTypes.size();
  return name + " " + kTypes[is_known ? static_cast<std::size_t>(datatype) : 0].name;
}

std::pair<double, double> PointCloudMessage::time_range() const {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for_each_place([&](std::size_t at) {
    const double time = number_at(at, fields[time_]);
    if ((time >= first && time <= last) || !std::isfinite(time) || !point_at(at).is_measured()) return;
    first = std::min(first, time);
    last = std::max(last, time);
  });
  return {first, last};
}

/// Reads a message, and holds what it states against its length before anything is read by it.
struct PointCloudDecoder {
  PointCloudMessage cloud;

  bool read(WireReader& wire) {
    const std::optional<MessageHeader> header = read_header(wire);
    if (!header) return false;
    cloud.stamp_s = header->stamp_s;
    cloud.frame = header->frame;
    cloud.height = wire.number<std::uint32_t>();
    cloud.width = wire.number<std::uint32_t>();
    cloud.fields.resize(wire.length(kLeastFieldBytes));
    for (PointField& field : cloud.fields) {
      field.name = wire.text();
      field.offset = wire.number<std::uint32_t>();
      field.datatype = wire.number<std::uint8_t>();
      wire.skip_numbers(1, sizeof(std::uint32_t));  // how many: some drivers write 0 for one
    }
    const bool is_big_endian = wire.number<std::uint8_t>() != 0;
    cloud.swap_ = is_big_endian != (std::endian::native == std::endian::big);
    cloud.point_step_ = wire.number<std::uint32_t>();
    cloud.row_step_ = wire.number<std::uint32_t>();
    cloud.data_ = wire.bytes();
    wire.skip_numbers(1, 1);  // is_dense: points are looked at in any case
    return wire.ok();
  }

  bool has_position() {
    constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
    for (std::size_t axis = 0; axis < kNames.size(); ++axis) {
      const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                      [&](const PointField& field) { return field.name == kNames[axis]; });
      if (found == cloud.fields.end() || !is_real(*found)) return false;
      cloud.xyz_[axis] = static_cast<std::size_t>(found - cloud.fields.begin());
    }
    return true;
  }

  void find_time() {
    const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(), is_time);
    if (found != cloud.fields.end() && lies_in_point(*found, cloud.point_step_))
      cloud.time_ = static_cast<std::size_t>(found - cloud.fields.begin());
  }

  bool fields_fit() const {
    return std::all_of(cloud.xyz_.begin(), cloud.xyz_.end(),
                       [this](std::size_t field) { return lies_in_point(cloud.fields[field], cloud.point_step_); });
  }

  /// Numbers of four bytes each: their products fit into eight. A single row needs no step to the next one.
  bool points_fit() {
    if (cloud.size() == 0) return true;
    const std::size_t row_bytes = cloud.width * cloud.point_step_;
    if (cloud.height == 1) cloud.row_step_ = row_bytes;
    if (cloud.row_step_ < row_bytes || row_bytes > cloud.data_.size()) return false;
    return cloud.height - 1 <= (cloud.data_.size() - row_bytes) / cloud.row_step_;
  }
};

DecodedPointCloud decode_point_cloud(Bytes message, Wire wire) {
  WireReader reader(message, wire);
  PointCloudDecoder decoder;
  if (!decoder.read(reader)) return {std::nullopt, "damaged PointCloud2 message"};
  if (!decoder.has_position()) return {std::nullopt, "PointCloud2 message without x, y and z as FLOAT32 or FLOAT64"};
  if (!decoder.fields_fit()) return {std::nullopt, "PointCloud2 message whose fields do not fit into a point"};
  if (!decoder.points_fit()) return {std::nullopt, "PointCloud2 message with fewer bytes than its points need"};
  if (decoder.cloud.size() > kMostPoints) return {std::nullopt, "PointCloud2 message with more than 4 million points"};
  decoder.find_time();
  return {std::move(decoder.cloud), ""};
}

PointTimes::PointTimes(const PointCloudMessage& cloud) {
  if (!cloud.time_field() || cloud.size() == 0) return;
  std::tie(first_, last_) = cloud.time_range();
  if (!(first_ < last_)) return;  // all at once
  double nearest_s = kMostSweep_s;
  for (const Reading& reading : readings_of(*cloud.time_field(), cloud.stamp_s)) {
    const double farthest_s =
        reading.unit_s * std::max(std::abs(first_ - reading.zero), std::abs(last_ - reading.zero));
    if (farthest_s > nearest_s || reading.unit_s * (last_ - first_) < kLeastSweep_s) continue;
    nearest_s = farthest_s;
    zero_ = reading.zero;
    unit_s_ = reading.unit_s;
  }
}

}  // namespace opal::recording
