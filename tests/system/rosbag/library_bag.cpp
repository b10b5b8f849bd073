#include "library_bag.hpp"

#include "tests/plugins/logs/ros1/ros1_writer.hpp"

#include <rosbag/bag.h>

namespace {

/// A message that is there in bytes already.
struct Ready {
  std::string type;
  std::string bytes;
};

}  // namespace

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<Ready> {
  static const char* value() { return "*"; }
  static const char* value(const Ready&) { return "00000000000000000000000000000000"; }
};
template <>
struct DataType<Ready> {
  static const char* value() { return "*"; }
  static const char* value(const Ready& ready) { return ready.type.c_str(); }
};
template <>
struct Definition<Ready> {
  static const char* value() { return ""; }
  static const char* value(const Ready&) { return ""; }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<Ready> {
  template <class Stream>
  static void write(Stream& stream, const Ready& ready) {
    std::memcpy(stream.advance(static_cast<std::uint32_t>(ready.bytes.size())), ready.bytes.data(), ready.bytes.size());
  }
  static std::uint32_t serializedLength(const Ready& ready) { return static_cast<std::uint32_t>(ready.bytes.size()); }
};

}  // namespace serialization
}  // namespace ros

void write_library_bag(const std::string& path, const std::string& compression) {
  using namespace opal::log_tests;
  rosbag::Bag bag;
  bag.open(path, rosbag::bagmode::Write);
  bag.setChunkThreshold(50'000);
  bag.setCompression(compression == "bz2"   ? rosbag::compression::BZ2
                     : compression == "lz4" ? rosbag::compression::LZ4
                                            : rosbag::compression::Uncompressed);
  for (int i = 0; i < 300; ++i) {
    const double stamp_s = 1000 + 0.1 * i;
    std::vector<float> ranges_m;
    for (int beam = 0; beam < 200; ++beam) ranges_m.push_back(1.0f + static_cast<float>((7 * beam + i) % 50) / 10);
    bag.write("/odom", ros::Time(stamp_s), Ready{"nav_msgs/Odometry", ros1_odometry(stamp_s, 0.05 * i)});
    bag.write("/scan", ros::Time(stamp_s), Ready{"sensor_msgs/LaserScan", ros1_scan(stamp_s, ranges_m)});
  }
  bag.close();
}
