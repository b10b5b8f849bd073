#pragma once

#include "recording/ros_messages.hpp"

#include <opal/recording/ros_log.hpp>

#include <functional>
#include <set>

namespace opal::recording {

using TopicTest = std::function<bool(const Topic&)>;

/// Indices of those topics of one file.
std::vector<std::size_t> topics_where(const Recording& part, const TopicTest& test);
TopicTest is_named(const std::string& name);

/// What is read of a recording.
struct ChosenTopics {
  TopicChoice topics;                ///< scans is not empty; odometry is if no topic has it
  std::vector<std::string> remarks;  ///< what a user should know of the choice
};

/// The topics of point clouds.
std::set<std::string> cloud_topics(const Parts& parts);
/// Whether there are point clouds, and no scans.
bool has_only_clouds(const Parts& parts);
/// @param lasers  how many are described. @throws ConfigError if more topics of scans are named than that.
void expect_laser_each(const TopicChoice& topics, std::size_t lasers);
/// What has odometry, where a topic and transforms both do.
enum class OdometryFirst { topic, transforms };
/// @param first  with transforms, a topic of odometry is only read where no transform is it.
/// @throws LogError if there is no scan, or no topic of a name that was asked for.
ChosenTopics choose_topics(const std::string& path, const Parts& parts, const TopicChoice& wanted,
                           OdometryFirst first = OdometryFirst::topic);

/// What transforms are the odometry, where no topic has it.
struct OdometryLink {
  bool exists = false;
  std::string base_frame;  ///< if it exists
  std::string complaint;   ///< if it does not: with the links that options could name
};

/// All topics of scans and of point clouds that are read.
std::vector<std::string> scan_topics_of(const TopicChoice& topics);
/// Whether scans of this topic are read, or slices of its point clouds.
bool reads_scans_of(const TopicChoice& topics, const std::string& topic);
/// Whether a transform leads from the frame of odometry to the robot.
bool is_odometry(const Transform& transform, const TopicChoice& topics);
OdometryLink find_odometry_link(const Parts& parts, const TopicChoice& topics);

/// When the first and the last message of a file were recorded; 0 for an empty file.
struct Span {
  double begin_s = 0, end_s = 0;
};
Span span_of(const Recording& part);

constexpr double kSecondsPerNanosecond = 1e-9;

}  // namespace opal::recording
