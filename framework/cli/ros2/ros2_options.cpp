#include "cli/ros2/ros2_options.hpp"

#include "cli/options/number_option.hpp"
#include "ros2/network/ros_names.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include <opal/common/error.hpp>
#include "common/phrases.hpp"

#include <algorithm>

namespace opal::cli {
namespace {

const std::vector<std::string> kSourcesOfRobot{"opal:McapLog", "opal:Ros2Bag"};

/// What the deployment says of recordings of this robot holds for the robot, too.
nlohmann::json recording_options(const Deployment& deployment) {
  nlohmann::json options{
      {"scan_topic", ""}, {"scan_topics", ""}, {"odometry_topic", ""}, {"odom_frame", "odom"}, {"base_frame", ""}};
  for (const PartConfig& source : deployment.log_sources)
    if (std::ranges::count(kSourcesOfRobot, source.type) > 0) options.merge_patch(source.options);
  return options;
}

std::vector<std::string> topics_of(const std::vector<LaserModel>& lasers) {
  std::vector<std::string> topics;
  for (const LaserModel& laser : lasers)
    if (!laser.topic.empty()) topics.push_back(laser.topic);
  return topics;
}

}  // namespace

void Ros2Options::add_topics(CLI::App& verb) {
  verb.add_option("--namespace", name_space, "of this node's topics: robot1 reads /robot1/scan");
  verb.add_option("--scan-topic", scan_topics, "sensor_msgs/LaserScan, one topic a laser; may be repeated (scan)")
      ->allow_extra_args(false);
  verb.add_option("--odometry-topic", odometry_topic,
                  "nav_msgs/Odometry instead of transforms (the usual topic if there are none)");
  verb.add_option("--tf-topic", rest.incoming.tf, "transforms, read and written")->capture_default_str();
  verb.add_option("--tf-static-topic", rest.incoming.tf_static, "transforms that never change")->capture_default_str();
  verb.add_option("--pose-topic", pose_topic, "where the pose is published")->capture_default_str();
  verb.add_option("--map-topic", map_topic, "where the map is published as a grid; /map in place of a map server")
      ->capture_default_str();
  verb.add_option("--map-frame", rest.frames.map, "fixed to the building")->capture_default_str();
  verb.add_option("--odom-frame", odom_frame, "fixed to the start of odometry (odom)");
  verb.add_option(
      "--base-frame", base_frame,
      "the robot, where messages of odometry do not name it; otherwise the first that a transform from odom "
      "leads to");
  verb.add_option("--transform-tolerance", rest.frames.transform_tolerance_s,
                  "seconds that the transform is stamped later than its scan")
      ->capture_default_str()
      ->check(in_range(0.0, 60.0));
}

void Ros2Options::add_network(CLI::App& verb) {
  CLI::Option* number = verb.add_option("--domain", domain, "of DDS; otherwise ROS_DOMAIN_ID, or 0");
  number->check(in_range(0, 232));
  verb.add_option(
          "--reach", reach,
          "localhost: programs on this machine; subnet: this network; system: as CYCLONEDDS_URI says. Otherwise "
          "ROS_AUTOMATIC_DISCOVERY_RANGE or ROS_LOCALHOST_ONLY, or localhost")
      ->check(CLI::IsMember({"localhost", "subnet", "system"}));
  verb.add_flag("--use-sim-time", rest.use_sim_time, "the time is that of /clock");
  CLI::Option* page = verb.add_flag("--serve{" + std::to_string(LiveServer::kUsualPort) + "}", port,
                                    "show the run to browsers on this machine; --serve=PORT for another port, 0 for "
                                    "any free one");
  page->check(port_of_flag());
  verb.parse_complete_callback([this, number, page] {
    has_domain = number->count() > 0;
    serve = page->count() > 0;
    port = std::max(0, port);  // a flag's value of 0 reads as "not", which is -1
  });
}

void Ros2Options::add_running(CLI::App& verb) {
  CLI::Option* const look =
      verb.add_flag("--check", check, "look at the robot, say what is there and what is missing, and publish nothing");
  verb.add_option("--record", rest.record_file,
                  "file (.mcap) to keep in what is received, as it was; if it is there, the next free name is taken")
      ->check([](const std::string& file) {
        return file.ends_with(".mcap") ? std::string() : in_quotes(file) + ", expected a name that ends in .mcap";
      })
      ->excludes(look);
  verb.add_option("--state", rest.state_file, "file to keep the last good pose in, a hint for the next start")
      ->excludes(look);
  verb.add_option("--evidence", learning.evidence,
                  "file (.json) to write after every ten visits: what the drive says of the map, for opal learn")
      ->excludes(look);
  verb.add_flag("--push", learning.is_pushed, "tell the map store the same of store:BUILDING, for all robots together")
      ->excludes(look);
  verb.add_option("--seconds", check_s, "with --check: how long")
      ->capture_default_str()
      ->check(in_range(0.5, 3600.0))
      ->needs(look);
  verb.add_option("-o,--out", out, "with --check: deployment document to write: CONFIG with the robot's laser in it")
      ->needs(look);
}

void Ros2Options::add_to(CLI::App& verb) {
  verb.add_option("CONFIG", config, "deployment document, or the name of one that ships")->capture_default_str();
  verb.add_option("--map", map, "map document, or a source to import; overrides the deployment's");
  add_topics(verb);
  add_network(verb);
  add_running(verb);
}

Deployment Ros2Options::deployment_if_any() const {
  Deployment deployment = read_deployment(session::config_file(config));
  if (!map.empty()) deployment.map = map;
  return deployment;
}

Deployment Ros2Options::deployment() const {
  Deployment deployment = deployment_if_any();
  session::expect_map(deployment, config);
  return deployment;
}

std::string Ros2Options::topic(const std::string& option, const std::string& name) const {
  const std::string whole = ros2::topic_in(name_space, name);
  if (!ros2::is_topic_name(whole))
    throw ConfigError(option + ": '" + whole + "', expected a name of a topic: letters, digits and _ between slashes");
  return whole;
}

/// The lasers with the whole names of their topics. Where point clouds are sliced, each topic of the command line is
/// for one of them.
std::vector<LaserModel> Ros2Options::lasers_of(const Deployment& deployment) const {
  std::vector<LaserModel> lasers = deployment.lasers;
  if (std::ranges::none_of(lasers, [](const LaserModel& laser) { return laser.slice.has_value(); })) return lasers;
  if (!scan_topics.empty() && scan_topics.size() != lasers.size())
    throw ConfigError("--scan-topic: given " + std::to_string(scan_topics.size()) +
                      " times, expected once for each of " + std::to_string(lasers.size()) +
                      " sensors, in the order of the deployment");
  for (std::size_t k = 0; k < lasers.size(); ++k) {
    if (!scan_topics.empty()) lasers[k].topic = scan_topics[k];
    if (!lasers[k].topic.empty()) lasers[k].topic = topic("/sensor/topic", lasers[k].topic);
  }
  return lasers;
}

recording::TopicChoice Ros2Options::choice_of(const Deployment& deployment) const {
  recording::TopicChoice choice = recording::topic_choice(recording_options(deployment));
  const std::vector<LaserModel> lasers = lasers_of(deployment);
  if (choice.scans.empty()) choice.scans = topics_of(lasers);
  if (!scan_topics.empty()) choice.scans = scan_topics;
  choice.odometry = odometry_topic;  // that of the deployment is read where no transform is odometry
  if (!odom_frame.empty()) choice.odom_frame = odom_frame;
  if (!base_frame.empty()) choice.base_frame = base_frame;
  for (std::string& scan : choice.scans) scan = topic("--scan-topic", scan);
  choice = recording::with_topics_of(std::move(choice), lasers);
  if (choice.scans.empty() && !choice.are_all_slices) choice.scans = {topic("--scan-topic", "scan")};
  if (!choice.odometry.empty()) choice.odometry = topic("--odometry-topic", choice.odometry);
  return choice;
}

bool Ros2Options::names_scans(const Deployment& deployment) const {
  return !scan_topics.empty() || !topics_of(deployment.lasers).empty() ||
         !recording::topic_choice(recording_options(deployment)).scans.empty();
}

bool Ros2Options::states_odom_frame(const Deployment& deployment) const {
  const auto states = [](const PartConfig& source) {
    return std::ranges::count(kSourcesOfRobot, source.type) > 0 && source.options.contains("odom_frame");
  };
  return !odom_frame.empty() || std::ranges::any_of(deployment.log_sources, states);
}

std::string Ros2Options::sources_doubt(const Deployment& deployment) const {
  return session::log_sources_doubt(deployment, kSourcesOfRobot);
}

ros2::NodeOptions Ros2Options::node(const Deployment& deployment) const {
  ros2::NodeOptions node = rest;
  node.read = choice_of(deployment);
  const std::string of_deployment = recording_options(deployment).at("odometry_topic");
  if (!of_deployment.empty()) node.odometry_without_transforms = topic("/log_sources", of_deployment);
  node.needs_mounts = takes_geometry_from_log(deployment);
  node.frames.odom = node.read.odom_frame;
  node.is_odom_frame_stated = states_odom_frame(deployment);
  node.incoming.tf = node.outgoing.tf = topic("--tf-topic", node.incoming.tf);
  node.incoming.tf_static = topic("--tf-static-topic", node.incoming.tf_static);
  node.outgoing.pose = topic("--pose-topic", pose_topic);
  node.outgoing.map = topic("--map-topic", map_topic);
  if (!name_space.empty()) {
    node.incoming.initial_pose = topic("--namespace", "initialpose");
    node.incoming.forget = topic("--namespace", "opal/forget");
    node.outgoing.places = topic("--namespace", "opal/places");
    node.outgoing.markers = topic("--namespace", "opal/place_markers");
    node.outgoing.walls = topic("--namespace", "opal/walls");
  }
  ros2::DiscoveryOptions asked{has_domain ? std::optional(domain) : std::nullopt, reach};
  node.range = ros2::discovery_range(ros2::process_environment(), asked);
  return node;
}

}  // namespace opal::cli
