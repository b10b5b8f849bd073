#pragma once

#include <opal/recording/recording.hpp>

#include <bzlib.h>

#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>

namespace opal::log_tests {

/// Writes little-endian numbers and texts as ROS 1 does.
class Ros1Writer {
 public:
  template <class Number>
  Ros1Writer& number(Number value) {
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    bytes_ += raw;
    return *this;
  }
  Ros1Writer& text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
    return *this;
  }
  Ros1Writer& stamp(double stamp_s) {
    const auto seconds = static_cast<std::uint32_t>(stamp_s);
    return number(seconds).number(static_cast<std::uint32_t>(std::lround((stamp_s - seconds) * 1e9)));
  }
  Ros1Writer& header(double stamp_s, const std::string& frame) {
    return number(std::uint32_t{7}).stamp(stamp_s).text(frame);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

inline std::string ros1_scan(double stamp_s, const std::vector<float>& ranges_m, const std::string& frame = "laser") {
  Ros1Writer message;
  message.header(stamp_s, frame).number(-1.0f).number(1.0f).number(0.5f).number(0.01f).number(0.1f);
  message.number(0.1f).number(12.0f).number(static_cast<std::uint32_t>(ranges_m.size()));
  for (const float range_m : ranges_m) message.number(range_m);
  return message.number(std::uint32_t{0}).bytes();
}

inline std::string ros1_odometry(double stamp_s, double x_m) {
  Ros1Writer message;
  message.header(stamp_s, "odom").text("base_link");
  for (const double value : {x_m, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) message.number(value);
  for (int i = 0; i < 36 + 6 + 36; ++i) message.number(0.0);  // covariance, twist, covariance
  return message.bytes();
}

inline std::string ros1_transform(double stamp_s, const std::string& parent, const std::string& child, double x_m) {
  Ros1Writer message;
  message.number(std::uint32_t{1}).header(stamp_s, parent).text(child);
  for (const double value : {x_m, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) message.number(value);
  return message.bytes();
}

/// Writes a bag of ROS 1 (format 2.0): chunks with their indices, connections at the end.
class Ros1BagWriter {
 public:
  /// @param compression  "none" or "bz2"
  explicit Ros1BagWriter(std::string compression = "none") : compression_(std::move(compression)) {
    bytes_ = "#ROSBAG V2.0\n" + record({{"op", "\x03"}, {"index_pos", std::string(8, '\0')}}, std::string(64, ' '));
  }

  std::uint32_t connection(const std::string& topic, const std::string& type) {
    const auto id = static_cast<std::uint32_t>(connections_.size());
    connections_.push_back(
        record({{"op", "\x07"}, {"conn", raw(id)}, {"topic", topic}}, fields({{"topic", topic}, {"type", type}})));
    chunk_ += connections_.back();
    return id;
  }
  void message(std::uint32_t connection, double recorded_s, const std::string& data) {
    Ros1Writer entry;
    entry.stamp(recorded_s);
    index_[connection] += entry.bytes() + raw(static_cast<std::uint32_t>(chunk_.size()));
    chunk_ += record({{"op", "\x02"}, {"conn", raw(connection)}, {"time", entry.bytes()}}, data);
  }
  void end_chunk() {
    const std::string size = raw(static_cast<std::uint32_t>(chunk_.size()));
    bytes_ += record({{"op", "\x05"}, {"compression", compression_}, {"size", size}}, packed());
    for (const auto& [connection, entries] : index_)
      bytes_ += record({{"op", "\x04"},
                        {"ver", raw(std::uint32_t{1})},
                        {"conn", raw(connection)},
                        {"count", raw(static_cast<std::uint32_t>(entries.size() / 12))}},
                       entries);
    chunk_.clear();
    index_.clear();
  }
  /// The bag with the connections at its end, as a recorder leaves it that was not killed.
  std::string closed() {
    if (!chunk_.empty()) end_chunk();
    std::string all = bytes_;
    const std::size_t index_pos = all.find("index_pos=") + 10;
    all.replace(index_pos, 8, raw(static_cast<std::uint32_t>(all.size())) + std::string(4, '\0'));
    for (const std::string& connection : connections_) all += connection;
    return all;
  }
  /// What is on the disk of a bag that was never closed.
  const std::string& bytes() const { return bytes_; }

 private:
  using Fields = std::vector<std::pair<std::string, std::string>>;

  static std::string raw(std::uint32_t value) { return Ros1Writer().number(value).bytes(); }
  static std::string fields(const Fields& fields) {
    Ros1Writer all;
    for (const auto& [name, value] : fields) all.text(name + "=" + value);
    return all.bytes();
  }
  static std::string record(const Fields& header, const std::string& data) {
    return Ros1Writer().text(fields(header)).text(data).bytes();
  }
  std::string packed() {
    if (compression_ == "none") return chunk_;
    auto size = static_cast<unsigned>(chunk_.size() + chunk_.size() / 100 + 600);
    std::string packed(size, '\0');
    if (BZ2_bzBuffToBuffCompress(packed.data(), &size, chunk_.data(), static_cast<unsigned>(chunk_.size()), 9, 0, 0) !=
        BZ_OK)
      throw std::runtime_error("bzip2 refuses");
    packed.resize(size);
    return packed;
  }

  std::string compression_, bytes_, chunk_;
  std::map<std::uint32_t, std::string> index_;
  std::vector<std::string> connections_;
};

}  // namespace opal::log_tests
