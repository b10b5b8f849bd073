// A robot with another middleware: it plays a CARMEN log to topics of ROS 2 by Fast DDS, and prints what it hears.
// Nothing of Opal is in it: CDR, DDS and types are those of Fast DDS and fastddsgen.
//
//   fastdds_robot DOMAIN SPEED (tf|odometry|both) (reliable|best_effort) LASER... < LOG
//
// LASER is MESSAGE,FRAME,TOPIC,(scan|cloud),ANGLE_MIN,ANGLE_INCREMENT,RANGE_MAX,SWEEP,X,Y,HEADING: what the log calls
// the laser's scans, how it is called and sends here, its beams, and where it is mounted. A laser that sends clouds is
// a 3D lidar of a few rings, 1 m above the floor and tilted; the scans are what it sees of the walls.

#include "fastdds_heard.hpp"
#include "fastdds_said.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace heard;
using namespace said;
using Clock = std::chrono::steady_clock;

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
  eprosima::fastdds::dds::Topic* topic_of(const std::string& name, TopicDataType* type) {
    const TypeSupport support(type);
    support.register_type(participant_);
    if (auto* known = dynamic_cast<eprosima::fastdds::dds::Topic*>(participant_->lookup_topicdescription(name)))
      return known;
    return participant_->create_topic(name, support.get_type_name(), TOPIC_QOS_DEFAULT);
  }
  DomainParticipant* participant_ = nullptr;
  Publisher* publisher_ = nullptr;
  Subscriber* subscriber_ = nullptr;
};

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
  /// @param motion  "tf", "odometry", or "both": then the messages of odometry say a tenth more way.
  Mouth(Robot& robot, const std::string& motion, bool reliable, std::vector<Laser> lasers)
      : by_transforms_(motion != "odometry"), hears_itself_(by_transforms_ && reliable), lasers_(std::move(lasers)) {
    auto* const fixed = robot.writer("rt/tf_static", new tf2_msgs::msg::dds_::TFMessage_PubSubType, true, true);
    motion_ = by_transforms_ ? robot.writer("rt/tf", new tf2_msgs::msg::dds_::TFMessage_PubSubType, reliable)
                             : robot.writer("rt/odom", new nav_msgs::msg::dds_::Odometry_PubSubType, reliable);
    if (motion == "both") wheels_ = robot.writer("rt/odom", new nav_msgs::msg::dds_::Odometry_PubSubType, reliable);
    hints_ = robot.writer("rt/initialpose", new geometry_msgs::msg::dds_::PoseWithCovarianceStamped_PubSubType, true);
    forget_ = robot.writer("rt/opal/forget", new std_msgs::msg::dds_::Empty_PubSubType, true);
    Transforms mounts;
    for (const Laser& laser : lasers_) {
      TopicDataType* const type = laser.sends_clouds
                                      ? static_cast<TopicDataType*>(new sensor_msgs::msg::dds_::PointCloud2_PubSubType)
                                      : new sensor_msgs::msg::dds_::LaserScan_PubSubType;
      scans_.push_back(robot.writer("rt" + laser.topic, type, reliable));
      mounts.transforms().push_back(mount_of(laser));
    }
    fixed->write(&mounts);
  }
  void wait_for_listeners() {
    wait_for_listener(motion_, "odometry", hears_itself_ ? 1 : 0);
    for (DataWriter* writer : scans_) wait_for_listener(writer, "scans", 0);
  }
  void say(const Record& record) {
    if (record.is_said()) return say_as_a_person(record);
    if (!record.is_scan() || lasers_.size() == 1) say_pose(record);
    for (std::size_t k = 0; k < lasers_.size(); ++k)
      if (record.kind == lasers_[k].message) say_scan(record, k);
  }

 private:
  void say_as_a_person(const Record& record) {
    if (record.kind == "HINT") {
      auto hint = hint_of(record);
      hints_->write(&hint);
    } else {
      std_msgs::msg::dds_::Empty_ nothing;
      forget_->write(&nothing);
    }
  }
  void say_pose(const Record& record) {
    if (by_transforms_) {
      Transforms pose;
      pose.transforms({link(record.stamp_s, "odom", "base_link", record.x, record.y, record.heading)});
      motion_->write(&pose);
    } else {
      nav_msgs::msg::dds_::Odometry_ pose = odometry_of(record);
      motion_->write(&pose);
    }
    if (wheels_) {
      Record longer = record;
      longer.x *= 1.1;
      longer.y *= 1.1;
      nav_msgs::msg::dds_::Odometry_ pose = odometry_of(longer);
      wheels_->write(&pose);
    }
    print("moved " + words(time_at(record.stamp_s)));
  }
  void say_scan(const Record& record, std::size_t k) {
    if (lasers_[k].sends_clouds) {
      auto cloud = cloud_of(record, lasers_[k]);
      scans_[k]->write(&cloud);
    } else {
      auto scan = scan_of(record, lasers_[k]);
      scans_[k]->write(&scan);
    }
  }

  bool by_transforms_;
  bool hears_itself_;  // its own ears ask for reliable transforms
  std::vector<Laser> lasers_;
  DataWriter* motion_ = nullptr;
  DataWriter* wheels_ = nullptr;
  DataWriter *hints_ = nullptr, *forget_ = nullptr;
  std::vector<DataWriter*> scans_;  // by laser
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) return 2;
  const double speed = std::stod(argv[2]);
  const std::vector<Record> records = read_log(std::cin);
  Robot robot(static_cast<unsigned>(std::stoi(argv[1])));
  const Ears ears(robot);
  std::vector<Laser> lasers;
  for (int i = 5; i < argc; ++i) lasers.push_back(laser_of(argv[i]));
  Mouth mouth(robot, argv[3], std::string(argv[4]) == "reliable", lasers);
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
