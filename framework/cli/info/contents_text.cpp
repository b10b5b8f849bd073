#include "cli/info/contents_text.hpp"

#include "sensing/deskew.hpp"

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace opal::cli {
namespace {

// Later than 2001: such times are since 1970 and not since the start of a clock of the log's own.
constexpr double kSurelySince1970S = 1e9;

std::string begin_words(const LogContents& contents) {
  if (contents.first_s < kSurelySince1970S) return fmt::format("from {:.2f} s", contents.first_s);
  return fmt::format("from {:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(contents.first_s)));
}

/// Messages that come in bursts have no rate.
std::string rate_words(const LogTopic& topic) {
  constexpr double kBurst = 10;
  const double mean_interval_s =
      (topic.last_s - topic.first_s) / std::max(1.0, static_cast<double>(topic.messages - 1));
  if (topic.interval_s <= 0) return fmt::format("{:>8}", "");
  if (topic.gaps == 0 && mean_interval_s > kBurst * topic.interval_s) return fmt::format("{:>8}", "bursts");
  return fmt::format("{:5.1f} Hz", 1 / topic.interval_s);
}

std::string topic_lines(const LogContents& contents) {
  std::size_t width = 5;
  for (const LogTopic& topic : contents.topics) width = std::max(width, topic.name.size());
  std::string text = fmt::format("\n{:<{}}  {:>9}  {:>8}  {:>8}  {:>8}  {}\n", "topic", width, "messages", "rate",
                                 "from", "to", "type");
  for (const LogTopic& topic : contents.topics) {
    text += fmt::format("{:<{}}  {:>9}  ", topic.name, width, topic.messages);
    text += rate_words(topic);
    if (topic.messages > 0)
      text += fmt::format("  {:6.1f} s  {:6.1f} s", topic.first_s - contents.first_s, topic.last_s - contents.first_s);
    else
      text += fmt::format("  {:>8}  {:>8}", "", "");
    text += "  " + topic.type + "\n";
  }
  for (const LogTopic& topic : contents.topics)
    if (topic.gaps > 0)
      text += fmt::format("{} pauses {} times; the longest pause is {:.1f} s, from {:.1f} s on\n", topic.name,
                          topic.gaps, topic.longest_gap_s, topic.longest_gap_at_s - contents.first_s);
  return text;
}

std::string beam_words(const LogLaser& laser) {
  std::string text = fmt::format("  {} beams", laser.beams);
  if (laser.angle_min_rad && laser.angle_increment_rad) {
    const double span_rad = *laser.angle_increment_rad * (laser.beams - 1);
    text += fmt::format(" over {:.1f} degrees, from {:.2f} degrees in steps of {:.4f}", degrees(std::abs(span_rad)),
                        degrees(*laser.angle_min_rad), degrees(*laser.angle_increment_rad));
    if (*laser.angle_increment_rad < 0) text += " (clockwise)";
  } else {
    text += "; the log does not state where they point: the deployment has to";
  }
  if (laser.other_scans > 0) text += fmt::format("; {} scans have another number of beams", laser.other_scans);
  return text + "\n";
}

std::string range_words(const LogLaser& laser) {
  std::string text = laser.farthest_m > 0
                         ? fmt::format("  returns from {:.2f} to {:.2f} m", laser.nearest_m, laser.farthest_m)
                         : "  no returns";
  if (laser.range_max_m > 0) text += fmt::format(" (stated: {:.2f} to {:.2f} m)", laser.range_min_m, laser.range_max_m);
  text += fmt::format("; {:.0f} % of readings are no return, {:.0f} % are invalid", 100 * laser.no_return_share,
                      100 * laser.invalid_share);
  if (laser.no_return_m > 0) text += fmt::format("; a range of {:.2f} m stands for no return", laser.no_return_m);
  return text + "\n";
}

std::string mount_words(const std::optional<LogMount>& stated) {
  if (!stated) return "  the log does not state where it is mounted\n";
  const LogMount& mount = *stated;
  const Pose2& pose = mount.T_base_laser;
  std::string text = fmt::format("  mounted on {} at x {:.3f} m, y {:.3f} m, heading {:.2f} degrees, height {:.2f} m",
                                 mount.parent, pose.x(), pose.y(), degrees(pose.heading_rad()), mount.height_m);
  if (mount.upside_down) text += ", upside down";
  if (mount.tilt_rad > 0.01) text += fmt::format(", tilted by {:.1f} degrees", degrees(mount.tilt_rad));
  return text + (mount.from_moving_topic ? "; stated on /tf, where it does not move\n" : "\n");
}

/// Scans may be stamped at their end or ahead of time, so that they seem to come early.
std::string delay_words(double recorded_after_s) {
  constexpr double kSameClock_s = 60;
  if (recorded_after_s == 0) return "";
  if (std::abs(recorded_after_s) > kSameClock_s) return "; stamps and recording go by different clocks";
  return fmt::format("; recorded {:.0f} ms {} its stamp", 1e3 * std::abs(recorded_after_s),
                     recorded_after_s > 0 ? "after" : "before");
}

std::string time_words(const LogLaser& laser) {
  std::string text = laser.sweep_s > 0 ? fmt::format("  a sweep takes {:.3f} s", laser.sweep_s)
                                       : "  the log does not state how long a sweep takes";
  return text + delay_words(laser.recorded_after_s) + "\n";
}

std::string laser_lines(const LogContents& contents) {
  std::string text;
  for (const LogLaser& laser : contents.lasers) {
    text += "\nlaser " + laser.topic + (laser.frame.empty() ? "" : ", frame " + laser.frame) +
            (laser.is_read ? ": is read\n" : ": is not read\n");
    text += beam_words(laser) + range_words(laser) + mount_words(laser.mount) + time_words(laser);
  }
  return contents.lasers.empty() && contents.clouds.empty() ? "\nno laser\n" : text;
}

std::string extent_words(const LogCloud& cloud) {
  const std::string frame = cloud.mount ? cloud.mount->parent : cloud.frame;
  return fmt::format(
      "  points from x {:.1f} to {:.1f}, y {:.1f} to {:.1f}, z {:.2f} to {:.2f} m in {}; {:.0f} % of them are valid\n",
      cloud.x_min_m, cloud.x_max_m, cloud.y_min_m, cloud.y_max_m, cloud.z_min_m, cloud.z_max_m, frame,
      100 * cloud.valid_share);
}

std::string cloud_lines(const LogContents& contents) {
  std::string text;
  for (const LogCloud& cloud : contents.clouds) {
    text += "\npoint clouds " + cloud.topic + ", frame " + cloud.frame +
            ": a slice of them is read if the deployment describes one\n";
    text += fmt::format("  {} x {} points", cloud.height, cloud.width) +
            fmt::format(" with {}\n", fmt::join(cloud.fields, ", "));
    text += extent_words(cloud) + mount_words(cloud.mount);
    text += cloud.time_field.empty()
                ? "  the log does not state when each point was measured\n"
                : fmt::format("  a cloud takes {:.3f} s, by {}\n", cloud.sweep_s, cloud.time_field);
    if (cloud.suggested)
      text +=
          fmt::format("  suggested slice: heights from {:.2f} to {:.2f} m{}\n", cloud.suggested->z_min_m,
                      cloud.suggested->z_max_m, cloud.mount ? "" : ", seen from the sensor: its mount is not known");
  }
  return text;
}

std::string odometry_lines(const LogContents& contents) {
  std::string text;
  for (const LogOdometry& odometry : contents.odometries) {
    text +=
        fmt::format("\nodometry {}, {} to {}: {}\n  {} poses, {:.1f} m driven, {:.0f} degrees turned", odometry.topic,
                    odometry.odom_frame, odometry.base_frame, odometry.is_read ? "is read" : "is not read",
                    odometry.poses, odometry.driven_m, degrees(odometry.turned_rad));
    text += delay_words(odometry.recorded_after_s) + "\n";
  }
  return contents.odometries.empty() ? "\nno odometry\n" : text;
}

std::string frame_lines(const LogContents& contents) {
  std::string text;
  for (const LogTransform& transform : contents.transforms)
    text += fmt::format("  {} to {} ({}{})\n", transform.parent, transform.child, transform.topic,
                        transform.moves ? (transform.is_static ? ", stated in several ways" : ", moves") : "");
  return text.empty() ? "" : "\nframes\n" + text;
}

/// A sweep that cannot be true. Its laser is named by its topic.
std::string sweep_doubt(const LogLaser& laser, const std::vector<LogTopic>& topics) {
  const auto topic = std::ranges::find_if(topics, [&](const LogTopic& named) { return named.name == laser.topic; });
  const double interval_s = topic == topics.end() ? 0 : topic->interval_s;
  if (!laser.is_read || is_possible_sweep(laser.sweep_s, interval_s)) return "";
  return "  laser " + laser.topic +
         fmt::format(": its time_increment says that a sweep takes {:.3f} s", laser.sweep_s) +
         (interval_s > 0 ? fmt::format(", and a scan comes every {:.3f} s", interval_s) : "") +
         ": sweeps are not corrected; sensor.sweep_s of the deployment can state the true time\n";
}

/// What makes a log that is whole useless.
std::string doubt_lines(const LogContents& contents) {
  constexpr double kStands = 0.05;  // [m] and [rad]
  constexpr double kBlind = 0.99;
  std::string text;
  for (const LogLaser& laser : contents.lasers)
    if (laser.is_read && laser.scans > 0 && laser.no_return_share + laser.invalid_share > kBlind)
      text += "  laser " + laser.topic + " sees nothing: hardly a reading is a return\n";
  for (const LogLaser& laser : contents.lasers) text += sweep_doubt(laser, contents.topics);
  for (const LogOdometry& odometry : contents.odometries)
    if (odometry.is_read && odometry.driven_m < kStands && odometry.turned_rad < kStands)
      text += "  odometry " + odometry.topic + " never moves: a robot is localized while it drives or turns\n";
  return text;
}

std::string defect_lines(const LogContents& contents) {
  std::string text = doubt_lines(contents);
  for (const auto& [cause, times] : contents.defects)
    text += "  " + cause + (times > 1 ? fmt::format(": {} times", times) : "") + "\n";
  return text.empty() ? "" : "\nto be aware of\n" + text;
}

}  // namespace

std::string contents_text(const LogContents& contents) {
  std::string text = contents.format + ", " + fmt::format("{:.1f} s ", contents.last_s - contents.first_s) +
                     begin_words(contents) + "\n";
  if (contents.looked_at_s < contents.last_s)
    text += fmt::format("lasers, odometry and frames are those of the first {:.1f} s\n",
                        contents.looked_at_s - contents.first_s);
  return text + topic_lines(contents) + laser_lines(contents) + cloud_lines(contents) + odometry_lines(contents) +
         frame_lines(contents) + defect_lines(contents);
}

}  // namespace opal::cli
