#include "recording/ros_topics.hpp"

#include <opal/common/error.hpp>
#include "common/phrases.hpp"

#include <algorithm>
#include <set>

namespace opal::recording {
namespace {

std::set<std::string> names_where(const Parts& parts, const TopicTest& test) {
  std::set<std::string> names;
  for (const auto& part : parts)
    for (const Topic& topic : part->topics())
      if (test(topic)) names.insert(topic.name);
  return names;
}

/// One kind of topic of which one is read.
struct Kind {
  std::string type, usual, option;
  TopicTest test;
};

const Kind kScans{"sensor_msgs/LaserScan", "/scan", "scan_topic", has_scans};
const Kind kClouds{"sensor_msgs/PointCloud2", "", "topic of the sensor", has_clouds};
const Kind kOdometry{"nav_msgs/Odometry", "/odom", "odometry_topic", has_odometry};

/// @param hint  what a user may do if the topic is not there.
/// @return empty if there is no topic of this kind and none is asked for, or if there are several.
std::string choose(const std::string& path, const std::set<std::string>& topics, const Kind& kind,
                   const std::string& wanted, const std::string& hint = "") {
  if (topics.contains("/" + wanted)) return "/" + wanted;  // people leave it out
  if (!wanted.empty() && !topics.contains(wanted))
    throw LogError(path + ": no topic " + wanted + " of type " + kind.type + " that can be read, there is " +
                   listed(topics, "none") + hint);
  if (!wanted.empty()) return wanted;
  if (topics.contains(kind.usual)) return kind.usual;
  return topics.size() == 1 ? *topics.begin() : "";
}

/// Where odometry may be that no topic of its own has.
std::string transforms_hint(const Parts& parts) {
  const auto topics = names_where(parts, [](const Topic& topic) { return has_transforms(topic, false); });
  return topics.empty() ? "" : "; without the option " + kOdometry.option + " it is taken from " + listed(topics);
}

/// What a user may do about point clouds that nobody reads.
std::string clouds_hint(const std::set<std::string>& clouds) {
  if (clouds.empty()) return "";
  return "; there are point clouds (" + listed(clouds) +
         "): the deployment has to describe a slice of them (sensor.slice)";
}

/// The topics of planar lasers.
void choose_scans(const std::string& path, const Parts& parts, const TopicChoice& wanted, ChosenTopics& chosen) {
  const std::set<std::string> scans = names_where(parts, kScans.test);
  for (std::string& scan : chosen.topics.scans) {  // there has to be each
    if (!scans.contains(scan) && cloud_topics(parts).contains(scan))
      throw LogError(path + ": " + scan + " has no scans" + clouds_hint({scan}));
    scan = choose(path, scans, kScans, scan);
  }
  if (!wanted.scans.empty()) return;
  if (scans.empty())
    throw LogError(path + ": no topic of type " + kScans.type + " that can be read" + clouds_hint(cloud_topics(parts)));
  const std::string scan = choose(path, scans, kScans, "");
  chosen.topics.scans = {scan.empty() ? *scans.begin() : scan};
  if (scans.size() > 1)
    chosen.remarks.push_back("several lasers (" + listed(scans) + "): " + chosen.topics.scans.front() +
                             " is read, the option scan_topic may name another one");
}

/// The topic of odometry; none where transforms are it.
void choose_odometry(const std::string& path, const Parts& parts, const TopicChoice& wanted, ChosenTopics& chosen) {
  const std::set<std::string> odometry = names_where(parts, kOdometry.test);
  chosen.topics.odometry =
      choose(path, odometry, kOdometry, wanted.odometry, odometry.empty() ? transforms_hint(parts) : "");
  if (chosen.topics.odometry.empty() && odometry.size() > 1)
    throw LogError(path + ": several topics of type " + kOdometry.type + " (" + listed(odometry) +
                   "), expected an option to choose one: odometry_topic=" + *odometry.begin());
  if (!chosen.topics.odometry.empty() && !wanted.base_frame.empty())
    chosen.remarks.push_back("the option base_frame is not used: " + chosen.topics.odometry + " is the odometry");
}

/// They are taken only where somebody asks for it: Opal needs none, and a recording of other software may have them of
/// another map.
void choose_hints(const Parts& parts, const TopicChoice& wanted, ChosenTopics& chosen) {
  constexpr const char* kUsual = "/initialpose";
  const std::set<std::string> hints = names_where(parts, has_hints);
  if (hints.contains("/" + wanted.hints)) chosen.topics.hints = "/" + wanted.hints;  // people leave it out
  if (wanted.hints.empty() && hints.contains(kUsual))
    chosen.remarks.push_back("hints of the pose on " + std::string(kUsual) +
                             " are not taken: the option hint_topic may name it");
  if (!wanted.hints.empty() && !hints.contains(chosen.topics.hints))
    chosen.remarks.push_back("no hints of the pose on " + wanted.hints + ", which the option hint_topic names");
}

/// A robot of several has its name before the topic's.
void choose_forget(const Parts& parts, const TopicChoice& wanted, ChosenTopics& chosen) {
  const std::set<std::string> names = names_where(parts, [&](const Topic& topic) {
    return has_type(topic, "std_msgs/Empty") && topic.name.ends_with(wanted.forget);
  });
  if (!names.empty() && !names.contains(wanted.forget)) chosen.topics.forget = *names.begin();
}

}  // namespace

std::vector<std::size_t> topics_where(const Recording& part, const TopicTest& test) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < part.topics().size(); ++i)
    if (test(part.topics()[i])) indices.push_back(i);
  return indices;
}

TopicTest is_named(const std::string& name) {
  return [name](const Topic& topic) { return topic.name == name; };
}

std::set<std::string> cloud_topics(const Parts& parts) { return names_where(parts, kClouds.test); }

bool has_only_clouds(const Parts& parts) {
  return names_where(parts, kScans.test).empty() && !cloud_topics(parts).empty();
}

void expect_laser_each(const TopicChoice& topics, std::size_t lasers) {
  const std::vector<std::string> all = scan_topics_of(topics);
  if (all.size() <= lasers) return;
  throw ConfigError(count_of(all.size(), "topic") + " of scans are named (" + listed(all) + "), and " +
                    count_of(lasers, "laser") + (lasers == 1 ? " is" : " are") +
                    " described, expected a list /sensor with a laser for each topic");
}

ChosenTopics choose_topics(const std::string& path, const Parts& parts, const TopicChoice& wanted,
                           OdometryFirst first) {
  ChosenTopics chosen{wanted, {}};
  if (!wanted.are_all_slices) choose_scans(path, parts, wanted, chosen);
  for (const auto& [topic, laser] : wanted.slices) choose(path, cloud_topics(parts), kClouds, topic);
  choose_hints(parts, wanted, chosen);
  choose_forget(parts, wanted, chosen);
  chosen.topics.odom_frame = without_slash(wanted.odom_frame);
  chosen.topics.base_frame = without_slash(wanted.base_frame);
  if (first == OdometryFirst::transforms && find_odometry_link(parts, chosen.topics).exists)
    chosen.topics.odometry.clear();
  else
    choose_odometry(path, parts, wanted, chosen);
  return chosen;
}

std::vector<std::string> scan_topics_of(const TopicChoice& topics) {
  std::vector<std::string> all = topics.scans;
  for (const auto& [topic, laser] : topics.slices) all.push_back(topic);
  return all;
}

bool reads_scans_of(const TopicChoice& topics, const std::string& topic) {
  return topics.slices.contains(topic) || std::ranges::find(topics.scans, topic) != topics.scans.end();
}

bool is_odometry(const Transform& transform, const TopicChoice& topics) {
  return without_slash(transform.parent) == topics.odom_frame &&
         (topics.base_frame.empty() || without_slash(transform.child) == topics.base_frame);
}

OdometryLink find_odometry_link(const Parts& parts, const TopicChoice& topics) {
  std::set<std::string> others;
  for (const auto& part : parts) {
    const auto walk = part->walk(topics_where(*part, [](const Topic& topic) { return has_transforms(topic, false); }));
    while (const auto message = walk->next())
      for (const Transform& transform :
           decode_transforms(message->data, part->topics()[message->topic].wire).value_or(std::vector<Transform>{})) {
        if (is_odometry(transform, topics)) return {true, without_slash(transform.child), ""};
        others.insert(without_slash(transform.parent) + " to " + without_slash(transform.child));
      }
  }
  const std::string frames = topics.odom_frame + (topics.base_frame.empty() ? "" : " to " + topics.base_frame);
  return {false, "",
          "no odometry: no topic has it, and no transform from " + frames +
              (others.empty() ? "" : "; the options odom_frame and base_frame may name one of " + listed(others))};
}

Span span_of(const Recording& part) {
  const auto [first_ns, last_ns] = part.span_ns();
  return {kSecondsPerNanosecond * static_cast<double>(first_ns), kSecondsPerNanosecond * static_cast<double>(last_ns)};
}

}  // namespace opal::recording
