// A robot with another middleware: it plays a CARMEN log to topics of ROS 2 by Fast DDS, and prints what it hears.
// Nothing of Opal is in it: CDR, DDS and types are those of Fast DDS and fastddsgen.
//
//   fastdds_robot DOMAIN SPEED (tf|odometry) (reliable|best_effort) < LOG

#include "fastdds_heard.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <chrono>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace heard;
using Clock = std::chrono::steady_clock;

// Recordings start at 0, which ROS takes for "never set".
constexpr long kEpochNs = 1'700'000'000L * 1'000'000'000L;

builtin_interfaces::msg::dds_::Time_ time_at(double log_s) {
  const long ns = kEpochNs + std::lround(log_s * 1e6) * 1000;
  builtin_interfaces::msg::dds_::Time_ time;
  time.sec(static_cast<int>(ns / 1'000'000'000L));
  time.nanosec(static_cast<unsigned>(ns % 1'000'000'000L));
  return time;
}

class Robot {
 public:
  explicit Robot(unsigned domain) {
    DomainParticipantQos qos;
    qos.transport().use_builtin_transports = false;
    auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.push_back("127.0.0.1");
    qos.transport().user_transports.push_back(udp);
    participant_ = DomainParticipantFactory::get_instance()->create_participant(domain, qos);
    publisher_ = participant_->create_publisher(PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  }

  DataWriter* writer(const std::string& topic, TopicDataType* type, bool reliable, bool latched = false) {
    DataWriterQos qos = DATAWRITER_QOS_DEFAULT;
    qos.reliability().kind = reliable ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
    qos.durability().kind = latched ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
    qos.history().depth = latched ? 1 : 100;
    qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    return publisher_->create_datawriter(topic_of(topic, type), qos);
  }
  DataReader* reader(const std::string& topic, TopicDataType* type, bool latched, DataReaderListener* listener) {
    DataReaderQos qos = DATAREADER_QOS_DEFAULT;
    qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
    qos.durability().kind = latched ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
    qos.history().depth = 1000;
    qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    return subscriber_->create_datareader(topic_of(topic, type), qos, listener);
  }

 private:
  Topic* topic_of(const std::string& name, TopicDataType* type) {
    const TypeSupport support(type);
    support.register_type(participant_);
    if (auto* known = dynamic_cast<Topic*>(participant_->lookup_topicdescription(name))) return known;
    return participant_->create_topic(name, support.get_type_name(), TOPIC_QOS_DEFAULT);
  }
  DomainParticipant* participant_ = nullptr;
  Publisher* publisher_ = nullptr;
  Subscriber* subscriber_ = nullptr;
};

struct Record {
  bool is_scan = false;
  double stamp_s = 0, x = 0, y = 0, heading = 0;
  std::vector<float> ranges;
};

/// ODOM x y heading tv rv accel stamp host stamp; FLASER n ranges... x y heading x y heading stamp host stamp
std::vector<Record> read_log(std::istream& log) {
  std::vector<Record> records;
  for (std::string line; std::getline(log, line);) {
    std::istringstream words(line);
    std::string kind, skipped;
    words >> kind;
    Record record;
    record.is_scan = kind == "FLASER";
    if (!record.is_scan && kind != "ODOM") continue;
    std::size_t beams = 0;
    if (record.is_scan) words >> beams;
    record.ranges.resize(beams);
    for (float& range : record.ranges) words >> range;
    for (int i = 0; record.is_scan && i < 3; ++i) words >> skipped;
    words >> record.x >> record.y >> record.heading;
    for (int i = 0; !record.is_scan && i < 3; ++i) words >> skipped;
    words >> record.stamp_s;
    records.push_back(record);
  }
  return records;
}

Transforms link(double stamp_s, const std::string& parent, const std::string& child, double x, double y,
                double heading) {
  geometry_msgs::msg::dds_::TransformStamped_ transform;
  transform.header().stamp(time_at(stamp_s));
  transform.header().frame_id(parent);
  transform.child_frame_id(child);
  transform.transform().translation().x(x);
  transform.transform().translation().y(y);
  transform.transform().rotation().z(std::sin(heading / 2));
  transform.transform().rotation().w(std::cos(heading / 2));
  Transforms message;
  message.transforms({transform});
  return message;
}

sensor_msgs::msg::dds_::LaserScan_ scan_of(const Record& record) {
  sensor_msgs::msg::dds_::LaserScan_ scan;
  scan.header().stamp(time_at(record.stamp_s));
  scan.header().frame_id("laser");
  scan.angle_min(-1.5707963268f);
  scan.angle_increment(0.0087266462600f);
  scan.angle_max(1.5707963268f);
  scan.range_min(0.0f);
  scan.range_max(81.0f);
  scan.ranges(record.ranges);
  return scan;
}

nav_msgs::msg::dds_::Odometry_ odometry_of(const Record& record) {
  nav_msgs::msg::dds_::Odometry_ pose;
  pose.header().stamp(time_at(record.stamp_s));
  pose.header().frame_id("odom");
  pose.child_frame_id("base_link");
  pose.pose().pose().position().x(record.x);
  pose.pose().pose().position().y(record.y);
  pose.pose().pose().orientation().z(std::sin(record.heading / 2));
  pose.pose().pose().orientation().w(std::cos(record.heading / 2));
  return pose;
}

/// @param own  listeners of this program, which do not count.
void wait_for_listener(DataWriter* writer, const char* what, int own) {
  for (int i = 0; i < 600; ++i) {
    PublicationMatchedStatus status;
    writer->get_publication_matched_status(status);
    if (status.current_count > own) return print(std::string("matched ") + what);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  print(std::string("nobody listens to ") + what);
}

/// Prints everything that a node of localization publishes.
class Ears {
 public:
  explicit Ears(Robot& robot) {
    robot.reader("rt/tf", new tf2_msgs::msg::dds_::TFMessage_PubSubType, false, &transforms_);
    robot.reader("rt/amcl_pose", new geometry_msgs::msg::dds_::PoseWithCovarianceStamped_PubSubType, true, &poses_);
    robot.reader("rt/opal/places", new geometry_msgs::msg::dds_::PoseArray_PubSubType, true, &places_);
    robot.reader("rt/opal/place_markers", new visualization_msgs::msg::dds_::MarkerArray_PubSubType, true, &markers_);
    robot.reader("rt/opal/map", new nav_msgs::msg::dds_::OccupancyGrid_PubSubType, true, &grids_);
    robot.reader("rt/diagnostics", new diagnostic_msgs::msg::dds_::DiagnosticArray_PubSubType, false, &diagnostics_);
  }

 private:
  Printer<Transforms> transforms_{words_of_transforms};
  Printer<Pose> poses_{words_of_pose};
  Printer<Places> places_{words_of_places};
  Printer<Markers> markers_{words_of_markers};
  Printer<Grid> grids_{words_of_grid};
  Printer<Diagnostics> diagnostics_{words_of_diagnostics};
};

/// Publishes what is in a log.
class Mouth {
 public:
  Mouth(Robot& robot, bool by_transforms, bool reliable) : by_transforms_(by_transforms) {
    auto* const fixed = robot.writer("rt/tf_static", new tf2_msgs::msg::dds_::TFMessage_PubSubType, true, true);
    motion_ = by_transforms ? robot.writer("rt/tf", new tf2_msgs::msg::dds_::TFMessage_PubSubType, reliable)
                            : robot.writer("rt/odom", new nav_msgs::msg::dds_::Odometry_PubSubType, reliable);
    scans_ = robot.writer("rt/scan", new sensor_msgs::msg::dds_::LaserScan_PubSubType, reliable);
    Transforms mount = link(0, "base_link", "laser", 0.78, 0, 0);
    fixed->write(&mount);
  }
  void wait_for_listeners() {
    wait_for_listener(motion_, "odometry", by_transforms_ ? 1 : 0);
    wait_for_listener(scans_, "scans", 0);
  }
  void say(const Record& record) {
    if (by_transforms_) {
      Transforms pose = link(record.stamp_s, "odom", "base_link", record.x, record.y, record.heading);
      motion_->write(&pose);
    } else {
      nav_msgs::msg::dds_::Odometry_ pose = odometry_of(record);
      motion_->write(&pose);
    }
    if (!record.is_scan) return;
    auto scan = scan_of(record);
    scans_->write(&scan);
  }

 private:
  bool by_transforms_;
  DataWriter* motion_ = nullptr;
  DataWriter* scans_ = nullptr;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const double speed = std::stod(argv[2]);
  const std::vector<Record> records = read_log(std::cin);
  Robot robot(static_cast<unsigned>(std::stoi(argv[1])));
  const Ears ears(robot);
  Mouth mouth(robot, std::string(argv[3]) == "tf", std::string(argv[4]) == "reliable");
  mouth.wait_for_listeners();
  const Clock::time_point begin = Clock::now();
  for (const Record& record : records) {
    const std::chrono::duration<double> after(record.stamp_s / speed);
    std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(after));
    mouth.say(record);
  }
  print("played");
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  std::_Exit(0);  // threads of Fast DDS may still print
}
