#include "sensing/log_tally.hpp"

namespace opal {
namespace {

/// Gathers what a log's records say, of one laser and one odometry.
class RecordTally {
 public:
  void take(const OdometryRecord& odometry) { own_.add(odometry.stamp_s, odometry.T_odom_base); }
  void take(const MountRecord& mount) { mounts_.push_back(mount); }
  void take(const HintRecord&) {}
  void take(const ForgetRecord&) {}
  void take(const RawScan& scan) {
    scan_stamps_.add(scan.stamp_s);
    laser_.add(scan);
    if (scan.T_odom_base) with_scans_.add(scan.stamp_s, *scan.T_odom_base);
  }

  LogContents contents() const {
    LogContents all;
    LogLaser laser;
    laser.topic = "scans";
    laser.is_read = true;
    laser_.tell(laser);
    for (const MountRecord& mount : mounts_)
      if (mount.child == laser.frame) laser.mount = LogMount{mount.parent, mount.T_parent_child};
    LogOdometry odometry{"odometry", "odom", "base_link", 0, 0, 0, 0, true};
    // Many logs hold each pose twice: by itself, and with the scan.
    const Odometry& poses = own_.is_empty ? with_scans_ : own_;
    poses.tally.tell(odometry);
    if (laser.scans > 0) all.lasers.push_back(laser);
    if (odometry.poses > 0) all.odometries.push_back(odometry);
    add_topic(all, "odometry", "odometry", poses.stamps);
    add_topic(all, "scans", "laser scan", scan_stamps_);
    return all;
  }

 private:
  struct Odometry {
    StampTally stamps;
    OdometryTally tally;
    bool is_empty = true;
    void add(double stamp_s, const Pose2& T_odom_base) {
      stamps.add(stamp_s);
      tally.add(T_odom_base);
      is_empty = false;
    }
  };

  static void add_topic(LogContents& all, const char* name, const char* type, const StampTally& stamps) {
    LogTopic topic;
    topic.name = name;
    topic.type = type;
    stamps.tell(topic);
    if (topic.messages == 0) return;
    all.first_s = all.topics.empty() ? topic.first_s : std::min(all.first_s, topic.first_s);
    all.last_s = all.topics.empty() ? topic.last_s : std::max(all.last_s, topic.last_s);
    all.looked_at_s = all.last_s;
    all.topics.push_back(topic);
  }

  StampTally scan_stamps_;
  LaserTally laser_;
  Odometry own_, with_scans_;
  std::vector<MountRecord> mounts_;
};

}  // namespace

LogContents contents_of(LogReader& reader) {
  RecordTally tally;
  while (const std::optional<LogRecord> record = reader.next())
    std::visit([&tally](const auto& kind) { tally.take(kind); }, *record);
  LogContents contents = tally.contents();
  contents.defects = reader.defects();
  return contents;
}

std::unique_ptr<LogReader> LogSource::open_for(const std::string& path, const std::vector<LaserModel>&) const {
  return open(path);
}

LogContents LogSource::contents(const std::string& path) const { return contents_of(*open(path)); }

}  // namespace opal
