#pragma once

#include <opal/deployment/deployment.hpp>
#include "cli/ros2/learning_robot.hpp"
#include "ros2/robot_node.hpp"
#include "viewer/serving/live_server.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace opal::cli {

/// What `opal ros2` is told.
struct Ros2Options {
  std::string config = "default", map, out;
  bool check = false;
  double check_s = 10;
  bool serve = false;
  int port = LiveServer::kUsualPort;
  std::string name_space, map_topic = "opal/map", pose_topic = "amcl_pose", odometry_topic, odom_frame, base_frame;
  std::vector<std::string> scan_topics;
  unsigned domain = 0;
  bool has_domain = false;
  std::string reach;
  LearningOptions learning;
  ros2::NodeOptions rest;  ///< frames, files and what else goes to the node as it is

  void add_to(CLI::App& verb);
  /// The deployment. @throws ConfigError if it has no map.
  Deployment deployment() const;
  /// The same, though it has no map.
  Deployment deployment_if_any() const;
  /// What the node is told: the command line wins over the options that the deployment gives to log sources.
  /// @throws ConfigError for names that ROS does not allow, and for wrong environment variables.
  ros2::NodeOptions node(const Deployment& deployment) const;
  /// In words, that the deployment gives options to log sources that are not for a robot; empty: it does not.
  std::string sources_doubt(const Deployment& deployment) const;
  /// Whether somebody says which scans are read.
  bool names_scans(const Deployment& deployment) const;

 private:
  std::vector<LaserModel> lasers_of(const Deployment& deployment) const;
  recording::TopicChoice choice_of(const Deployment& deployment) const;
  bool states_odom_frame(const Deployment& deployment) const;
  std::string topic(const std::string& option, const std::string& name) const;
  void add_topics(CLI::App& verb);
  void add_network(CLI::App& verb);
  void add_running(CLI::App& verb);
};

}  // namespace opal::cli
