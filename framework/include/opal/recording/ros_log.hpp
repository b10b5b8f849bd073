#pragma once

#include <opal/recording/recording.hpp>
#include <opal/sensing/log_source.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace opal::recording {

/// What to read of a recording.
struct TopicChoice {
  std::vector<std::string> scans = {};  ///< topics; empty: the one of the usual name (/scan), or the first by name
  std::string odometry = {};        ///< topic; empty: the only one of its type, or the one of the usual name (/odom)
  std::string odom_frame = "odom";  ///< where no topic has odometry: the transforms from this frame are it,
  std::string base_frame = {};      ///< to this one; empty: to the first that a transform leads to
  /// Topics of point clouds that are read, too, and the slices that are taken of them.
  std::map<std::string, LaserModel> slices = {};
  bool are_all_slices = false;          ///< no topic of scans is read
  std::string hints = {};               ///< topic of hints; empty: none are read
  std::string forget = "/opal/forget";  ///< topic of Empty: whoever publishes there wants all to be forgotten
  std::string map_frame = "map";        ///< that hints are given in
};

/// The choice that the options of a plugin state: scan_topic, scan_topics (with commas), odometry_topic, odom_frame,
/// base_frame, and hint_topic, which may be missing.
TopicChoice topic_choice(const nlohmann::json& options);

/// The same with the slices that lasers of a deployment describe. Where nothing names topics of scans, several lasers
/// do, if each has one.
TopicChoice with_topics_of(TopicChoice choice, const std::vector<LaserModel>& lasers);

/// One recording may have several files.
using Parts = std::vector<std::unique_ptr<Recording>>;

/// Logs with messages of ROS, in any container: one file, or a folder with the files of one recording.
class RosLogSource : public LogSource {
 public:
  /// @param topics  what to read
  explicit RosLogSource(TopicChoice topics) : topics_(std::move(topics)) {}
  bool recognizes(const std::string& path) const final;
  /// Before anything else the reader tells where the lasers are mounted, if the transforms say so.
  std::unique_ptr<LogReader> open(const std::string& path) const final;
  std::unique_ptr<LogReader> open_for(const std::string& path, const std::vector<LaserModel>& lasers) const final;
  LogContents contents(const std::string& path) const final;

 protected:
  /// Whether a file looks like this container. What it throws counts as no.
  virtual bool recognizes_file(const std::string& file) const = 0;
  /// Opens one file. @throws LogError
  virtual std::unique_ptr<Recording> read(const std::string& file) const = 0;
  /// What messages call the container: "ROS 2 bag".
  virtual std::string format() const = 0;
  /// How the names of its files end in a folder: ".mcap".
  virtual std::string ending() const = 0;

 private:
  Parts parts_of(const std::vector<std::string>& files) const;
  std::vector<std::string> files_of(const std::string& path) const;
  std::unique_ptr<LogReader> open_with(const std::string& path, const TopicChoice& topics) const;

  TopicChoice topics_;
};

}  // namespace opal::recording
