#pragma once

#include <sqlite3.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace opal::log_tests {

/// Writes plain CDR in either byte order.
class CdrWriter {
 public:
  explicit CdrWriter(bool big_endian = false) : big_endian_(big_endian) {
    bytes_ = {0, big_endian ? '\0' : '\1', 0, 0};
  }

  template <class Number>
  CdrWriter& number(Number value) {
    while ((bytes_.size() - 4) % sizeof value != 0) bytes_ += '\x5a';  // padding has no meaning
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    bytes_.append(big_endian_ ? std::string(raw.rbegin(), raw.rend()) : raw);
    return *this;
  }
  CdrWriter& text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    bytes_ += text;
    bytes_ += '\0';
    return *this;
  }
  CdrWriter& header(double stamp_s, const std::string& frame) {
    const auto seconds = static_cast<std::int32_t>(stamp_s);
    return number(seconds).number(static_cast<std::uint32_t>(std::lround((stamp_s - seconds) * 1e9))).text(frame);
  }
  CdrWriter& pose(const std::vector<double>& position_and_quaternion) {
    for (const double value : position_and_quaternion) number(value);
    return *this;
  }
  CdrWriter& floats(const std::vector<float>& values) {
    number(static_cast<std::uint32_t>(values.size()));
    for (const float value : values) number(value);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  bool big_endian_;
};

struct LaserScanMessage {
  double stamp_s = 0;
  std::string frame = "laser";
  float angle_min_rad = -1;
  float angle_increment_rad = 0.5f;
  float range_min_m = 0.1f;
  float range_max_m = 12;
  std::vector<float> ranges_m{1, 2, 3};
  bool big_endian = false;

  std::string bytes() const {
    CdrWriter cdr(big_endian);
    cdr.header(stamp_s, frame).number(angle_min_rad).number(1.0f).number(angle_increment_rad).number(0.0f).number(0.1f);
    return cdr.number(range_min_m).number(range_max_m).floats(ranges_m).floats({}).bytes();
  }
};

inline std::string odometry_bytes(double stamp_s, const std::vector<double>& pose,
                                  const std::string& base = "base_link", bool big_endian = false) {
  CdrWriter cdr(big_endian);
  cdr.header(stamp_s, "odom").text(base).pose(pose);
  for (int i = 0; i < 36 + 6 + 36; ++i) cdr.number(0.0);  // covariance, twist, covariance
  return cdr.bytes();
}

struct Link {
  std::string parent;
  std::string child;
  std::vector<double> pose;
};

inline std::string transforms_bytes(const std::vector<Link>& links, double stamp_s = 0) {
  CdrWriter cdr;
  cdr.number(static_cast<std::uint32_t>(links.size()));
  for (const Link& link : links) cdr.header(stamp_s, link.parent).text(link.child).pose(link.pose);
  return cdr.bytes();
}

/// Writes a .db3 file with the two tables that a ROS 2 recording has.
class BagWriter {
 public:
  explicit BagWriter(const std::string& path) {
    if (sqlite3_open(path.c_str(), &database_) != SQLITE_OK) throw std::runtime_error(path + ": cannot be written");
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
        " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
        " data BLOB NOT NULL); CREATE INDEX timestamp_idx ON messages (timestamp ASC); BEGIN");
  }
  ~BagWriter() {
    run("COMMIT");
    sqlite3_close(database_);
  }
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// @return the topic's number.
  int topic(const std::string& name, const std::string& type, const std::string& format = "cdr") {
    run("INSERT INTO topics(name, type, serialization_format, offered_qos_profiles) VALUES('" + name + "','" + type +
        "','" + format + "','')");
    return static_cast<int>(sqlite3_last_insert_rowid(database_));
  }
  int scans(const std::string& name = "/scan") { return topic(name, "sensor_msgs/msg/LaserScan"); }
  int odometry(const std::string& name = "/odom") { return topic(name, "nav_msgs/msg/Odometry"); }
  int transforms() { return topic("/tf", "tf2_msgs/msg/TFMessage"); }
  int static_transforms() { return topic("/tf_static", "tf2_msgs/msg/TFMessage"); }

  void message(int topic, double recorded_s, const std::string& data) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database_, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?,?,?)", -1, &statement,
                       nullptr);
    sqlite3_bind_int(statement, 1, topic);
    sqlite3_bind_int64(statement, 2, static_cast<sqlite3_int64>(recorded_s * 1e9));
    sqlite3_bind_blob(statement, 3, data.data(), static_cast<int>(data.size()), SQLITE_TRANSIENT);
    sqlite3_step(statement);
    sqlite3_finalize(statement);
  }

 private:
  void run(const std::string& sql) { sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr); }

  sqlite3* database_ = nullptr;
};

}  // namespace opal::log_tests
