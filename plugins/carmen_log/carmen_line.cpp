#include "carmen_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace opal::carmen_log {
namespace {

constexpr int kMostReadings = 100'000;
constexpr double kFarthest_m = 1e7;
constexpr double kLatestStamp_s = 1e11;

constexpr const char* kMalformed = "malformed line";
constexpr const char* kTruncated = "truncated last line";
constexpr const char* kBadStamp = "stamp that is no time";
constexpr const char* kBadPose = "odometry that is no pose";

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Walks the words of a line. After the first failure every further reading fails, too.
class Words {
 public:
  Words(std::string_view text, bool terminated) : rest_(text), terminated_(terminated) {}

  std::string_view word() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
    const auto end = std::find_if(rest_.begin(), rest_.end(), is_blank);
    const auto length = static_cast<std::size_t>(end - rest_.begin());
    const std::string_view found = rest_.substr(0, length);
    rest_.remove_prefix(length);
    // A word that the file's end may have cut short is no word.
    if (found.empty() || (rest_.empty() && !terminated_)) ended_ = true;
    return found;
  }
  template <class Number>
  Number number() {
    std::string_view text = word();
    if (text.starts_with('+')) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) wrong_ = true;
    return value;
  }
  void skip(int words) {
    for (int i = 0; i < words; ++i) word();
  }
  Pose2 pose() {
    const auto x_m = number<double>();
    const auto y_m = number<double>();
    const auto heading_rad = number<double>();
    // Also false for NaN.
    pose_ok_ = pose_ok_ && std::abs(x_m) < kFarthest_m && std::abs(y_m) < kFarthest_m && std::abs(heading_rad) < 1e6;
    return pose_ok_ ? Pose2(x_m, y_m, heading_rad) : Pose2();
  }
  bool at_end() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
    return rest_.empty();
  }
  bool ok() const { return !wrong_ && !ended_; }
  bool pose_ok() const { return pose_ok_; }
  const char* defect() const { return ended_ && !terminated_ ? kTruncated : kMalformed; }

 private:
  std::string_view rest_;
  bool terminated_;
  bool ended_ = false;  // there were too few words
  bool wrong_ = false;  // a word was no number
  bool pose_ok_ = true;
};

/// Reads the stamp; host and logger's time may follow, and nothing else: more or fewer words mean that the readings
/// were not as many as announced.
const char* finish(Words& words, double& stamp_s) {
  stamp_s = words.number<double>();
  if (!words.ok()) return words.defect();
  for (int trailing = 0; trailing < 2 && !words.at_end(); ++trailing) words.word();
  if (!words.at_end()) return kMalformed;
  return std::abs(stamp_s) < kLatestStamp_s ? nullptr : kBadStamp;
}

ParsedLine parse_odometry(Words words) {
  OdometryRecord odometry;
  odometry.T_odom_base = words.pose();
  words.skip(3);  // tv rv accel
  if (const char* defect = finish(words, odometry.stamp_s)) return {{}, defect};
  if (!words.pose_ok()) return {{}, kBadPose};
  return {odometry, nullptr};
}

bool read_ranges(Words& words, std::vector<float>& ranges_m) {
  const int count = words.number<int>();
  if (!words.ok() || count < 0 || count > kMostReadings) return false;
  ranges_m.resize(static_cast<std::size_t>(count));
  for (float& range_m : ranges_m) {
    range_m = words.number<float>();
    if (!words.ok()) return false;
  }
  return true;
}

ParsedLine finish_scan(Words& words, RawScan scan, const std::optional<Pose2>& T_odom_base) {
  if (const char* defect = finish(words, scan.stamp_s)) return {{}, defect};
  if (!words.pose_ok()) return {std::move(scan), kBadPose};
  scan.T_odom_base = T_odom_base;
  return {std::move(scan), nullptr};
}

/// FLASER n r1 .. rn x y theta odom_x odom_y odom_theta stamp host logger_stamp
ParsedLine parse_old_laser(Words words, std::string_view message) {
  RawScan scan;
  scan.frame = message;
  if (!read_ranges(words, scan.ranges_m)) return {{}, words.defect()};
  words.skip(3);  // the laser's pose
  const Pose2 T_odom_base = words.pose();
  return finish_scan(words, std::move(scan), T_odom_base);
}

/// ROBOTLASER1 type angle_min fov angle_increment range_max accuracy remission_mode n r1 .. rn m e1 .. em
///   laser_x laser_y laser_theta x y theta tv rv safety_front safety_side turn_axis stamp host logger_stamp
/// RAWLASER1 is the same without what is between e_m and the stamp.
ParsedLine parse_new_laser(Words words, std::string_view message) {
  RawScan scan;
  scan.frame = message;
  words.skip(1);
  scan.angle_min_rad = words.number<double>();
  words.skip(1);
  scan.angle_increment_rad = words.number<double>();
  words.skip(3);
  if (!read_ranges(words, scan.ranges_m)) return {{}, words.defect()};
  const int remissions = words.number<int>();
  if (!words.ok() || remissions < 0 || remissions > kMostReadings) return {{}, words.defect()};
  words.skip(remissions);
  if (!std::isfinite(*scan.angle_min_rad) || !std::isfinite(*scan.angle_increment_rad)) return {{}, kMalformed};
  if (message.starts_with("RAW")) return finish_scan(words, std::move(scan), std::nullopt);
  words.skip(3);  // the laser's pose
  const Pose2 T_odom_base = words.pose();
  words.skip(5);
  return finish_scan(words, std::move(scan), T_odom_base);
}

bool is_new_laser(std::string_view message) {
  return message.starts_with("ROBOTLASER") || message.starts_with("RAWLASER");
}

}  // namespace

ParsedLine parse_line(std::string_view text, bool terminated, std::span<const std::string> laser_messages) {
  Words words(text, terminated);
  const std::string_view message = words.word();
  if (message.empty() || message.front() == '#') return {};
  const bool cut = !words.ok();
  if (cut) return {{}, kTruncated};
  if (message == "ODOM") return parse_odometry(words);
  if (std::find(laser_messages.begin(), laser_messages.end(), message) != laser_messages.end())
    return is_new_laser(message) ? parse_new_laser(words, message) : parse_old_laser(words, message);
  return is_carmen_message(message) ? ParsedLine{} : ParsedLine{{}, kMalformed};
}

std::string_view message_of(std::string_view text) { return Words(text, true).word(); }

bool is_laser_message(std::string_view message) {
  return message == "FLASER" || message == "RLASER" || message.starts_with("LASER") || is_new_laser(message);
}

bool is_carmen_message(std::string_view message) {
  constexpr std::array<std::string_view, 16> kOthers{
      "ODOM",   "PARAM", "SYNC",  "TRUEPOS", "NMEAGGA",  "NMEARMC",  "NMEA", "GPS",
      "MARKER", "IMU",   "SONAR", "BUMPER",  "SCANMARK", "POSITION", "ARM",  "CORRECTION"};
  return is_laser_message(message) || std::find(kOthers.begin(), kOthers.end(), message) != kOthers.end();
}

}  // namespace opal::carmen_log
