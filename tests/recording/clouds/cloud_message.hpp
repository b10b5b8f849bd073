#pragma once

#include "tests/plugins/logs/bag_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace opal::recording_tests {

inline constexpr std::uint8_t kUint8 = 2, kUint32 = 6, kFloat32 = 7, kFloat64 = 8;

/// One point and when it was measured, as the message has it.
struct MadePoint {
  double x = 0, y = 0, z = 0, time = 0;
};

/// Writes sensor_msgs/PointCloud2 in any of its layouts.
struct CloudMessage {
  double stamp_s = 1;
  std::string frame = "lidar";
  std::uint8_t number_type = kFloat32;  ///< of x, y and z
  std::string time_name = "";           ///< empty: no such field
  std::uint8_t time_type = kUint32;
  std::size_t padding = 0;  ///< bytes before, between and after the fields
  std::size_t row_padding = 0;
  std::uint32_t height = 1;
  bool big_endian_data = false;
  std::vector<MadePoint> points;

  struct Field {
    std::string name;
    std::uint32_t offset;
    std::uint8_t type;
  };

  static std::size_t bytes_of(std::uint8_t type) { return type == kFloat64 ? 8 : (type == kUint8 ? 1 : 4); }

  std::vector<Field> fields() const {
    std::vector<Field> all{{"intensity", 0, kUint8}};
    std::size_t at = 1;
    const auto add = [&](const std::string& name, std::uint8_t type) {
      at += padding;
      all.push_back({name, static_cast<std::uint32_t>(at), type});
      at += bytes_of(type);
    };
    for (const char* name : {"x", "y", "z"}) add(name, number_type);
    if (!time_name.empty()) add(time_name, time_type);
    return all;
  }
  std::size_t point_step() const { return fields().back().offset + bytes_of(fields().back().type) + padding; }
  std::uint32_t width() const { return static_cast<std::uint32_t>(points.size() / height); }
  std::size_t row_step() const { return width() * point_step() + row_padding; }

  template <class Number>
  void put(std::string& to, std::size_t at, Number value) const {
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    if (big_endian_data) std::reverse(raw.begin(), raw.end());
    to.replace(at, raw.size(), raw);
  }
  void put(std::string& to, std::size_t at, double value, std::uint8_t type) const {
    if (type == kFloat32) put(to, at, static_cast<float>(value));
    if (type == kFloat64) put(to, at, value);
    if (type == kUint32) put(to, at, static_cast<std::uint32_t>(value));
    if (type == kUint8) put(to, at, static_cast<std::uint8_t>(value));
  }

  std::string data() const {
    std::string data(row_step() * height, '\x5a');
    const std::vector<Field> places = fields();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t at = i / width() * row_step() + i % width() * point_step();
      const double values[] = {7, points[i].x, points[i].y, points[i].z, points[i].time};
      for (std::size_t k = 0; k < places.size(); ++k) put(data, at + places[k].offset, values[k], places[k].type);
    }
    return data;
  }

  /// @param writer  CdrWriter or Ros1Writer.
  template <class Writer>
  std::string written(Writer writer) const {
    writer.header(stamp_s, frame).number(height).number(width());
    const std::vector<Field> places = fields();
    writer.number(static_cast<std::uint32_t>(places.size()));
    for (const Field& field : places)
      writer.text(field.name).number(field.offset).number(field.type).number(std::uint32_t{1});
    writer.number(static_cast<std::uint8_t>(big_endian_data));
    writer.number(static_cast<std::uint32_t>(point_step())).number(static_cast<std::uint32_t>(row_step()));
    const std::string bytes = data();
    writer.number(static_cast<std::uint32_t>(bytes.size()));
    for (const char byte : bytes) writer.number(static_cast<std::uint8_t>(byte));
    return writer.number(std::uint8_t{0}).bytes();
  }
  std::string bytes(bool big_endian = false) const { return written(log_tests::CdrWriter(big_endian)); }
};

}  // namespace opal::recording_tests
