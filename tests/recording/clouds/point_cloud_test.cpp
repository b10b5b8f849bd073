#include "recording/point_cloud.hpp"
#include "cloud_message.hpp"
#include "tests/plugins/logs/ros1/ros1_writer.hpp"

#include <catch2/catch.hpp>

#include <span>

using namespace opal;
using namespace opal::recording;
using namespace opal::recording_tests;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Bytes view(const std::string& text) { return std::as_bytes(std::span(text)); }

CloudMessage four_points() {
  CloudMessage made;
  made.points = {{1, 2, 3}, {-4, 5, -6}, {0.5, 0.25, 0.125}, {7, 8, 9}};
  return made;
}

void check_points(const std::string& message, Wire wire, const CloudMessage& made) {
  const DecodedPointCloud decoded = decode_point_cloud(view(message), wire);
  CHECK(decoded.complaint.empty());
  REQUIRE(decoded.cloud);
  CHECK(decoded.cloud->frame == "lidar");
  CHECK(decoded.cloud->stamp_s == Approx(made.stamp_s));
  REQUIRE(decoded.cloud->size() == made.points.size());
  for (std::size_t i = 0; i < made.points.size(); ++i) {
    const auto point = decoded.cloud->point(i);
    CHECK(point.x_m == made.points[i].x);
    CHECK(point.y_m == made.points[i].y);
    CHECK(point.z_m == made.points[i].z);
  }
}

/// The same message with other numbers where the layout stands.
std::string complaint_about(const std::vector<CloudMessage::Field>& fields, std::uint32_t height, std::uint32_t width,
                            std::uint32_t point_step, std::uint32_t row_step, std::size_t data_bytes) {
  log_tests::CdrWriter writer;
  writer.header(1, "lidar").number(height).number(width).number(static_cast<std::uint32_t>(fields.size()));
  for (const auto& field : fields)
    writer.text(field.name).number(field.offset).number(field.type).number(std::uint32_t{1});
  writer.number(std::uint8_t{0}).number(point_step).number(row_step);
  writer.number(static_cast<std::uint32_t>(data_bytes));
  for (std::size_t i = 0; i < data_bytes; ++i) writer.number(std::uint8_t{0});
  const std::string message = writer.number(std::uint8_t{1}).bytes();
  const DecodedPointCloud decoded = decode_point_cloud(view(message), Wire::cdr);
  CHECK(decoded.cloud.has_value() == decoded.complaint.empty());
  return decoded.complaint;
}

const std::vector<CloudMessage::Field> kXyz{{"x", 0, kFloat32}, {"y", 4, kFloat32}, {"z", 8, kFloat32}};

}  // namespace

TEST_CASE("points are found in either byte order, at any offset, in either precision, in any rows") {
  for (const bool big_endian : {false, true})
    for (const bool big_endian_data : {false, true})
      for (const std::uint8_t type : {kFloat32, kFloat64})
        for (const std::size_t padding : {0, 3})
          for (const std::uint32_t height : {1, 2}) {
            CloudMessage made = four_points();
            made.big_endian_data = big_endian_data;
            made.number_type = type;
            made.padding = padding;
            made.row_padding = height == 2 ? 5 : 0;
            made.height = height;
            check_points(made.bytes(big_endian), Wire::cdr, made);
            check_points(made.written(log_tests::Ros1Writer()), Wire::ros1, made);
          }
}

TEST_CASE("a single row needs no step to the next one") {
  CHECK(complaint_about(kXyz, 1, 2, 12, 0, 24).empty());
  CHECK(complaint_about(kXyz, 2, 1, 12, 0, 24) == "PointCloud2 message with fewer bytes than its points need");
}

TEST_CASE("points that are NaN or lie at the sensor are no measurements") {
  CloudMessage made;
  made.points = {{kNaN, 0, 0}, {0, 0, 0}, {1, std::numeric_limits<double>::infinity(), 0}, {1, 0, 0}};
  const std::string message = made.bytes();
  const DecodedPointCloud decoded = decode_point_cloud(view(message), Wire::cdr);
  REQUIRE(decoded.cloud);
  for (std::size_t i = 0; i < 3; ++i) CHECK_FALSE(decoded.cloud->point(i).is_measured());
  CHECK(decoded.cloud->point(3).is_measured());
}

TEST_CASE("a message that ends early is damaged, wherever it ends") {
  const std::string whole = four_points().bytes();
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    const DecodedPointCloud decoded = decode_point_cloud(view(whole).first(bytes), Wire::cdr);
    CHECK_FALSE(decoded.cloud);
    CHECK(decoded.complaint == "damaged PointCloud2 message");
  }
}

TEST_CASE("sizes that cannot be are refused in words") {
  const std::string few = "PointCloud2 message with fewer bytes than its points need";
  const std::string fields = "PointCloud2 message whose fields do not fit into a point";
  const std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  CHECK(complaint_about(kXyz, 2, 2, 12, 24, 48).empty());
  CHECK(complaint_about(kXyz, 2, 2, 12, 24, 47) == few);
  CHECK(complaint_about(kXyz, 2, 2, 12, 23, 48) == few);
  CHECK(complaint_about(kXyz, most, most, 12, most, 48) == few);
  CHECK(complaint_about(kXyz, 1, most, most, most, 48) == few);
  CHECK(complaint_about(kXyz, most, 0, 12, 0, 0).empty());  // no points
  CHECK(complaint_about(kXyz, most, most, 0, 0, 0) == fields);
  CHECK(complaint_about(kXyz, 1, 1, 11, 11, 11) == fields);
  CHECK(complaint_about({kXyz[0], kXyz[1], {"z", most, kFloat32}}, 1, 1, 12, 12, 12) == fields);
  CHECK(complaint_about(kXyz, 2100, 2000, 12, 24000, 2100 * 24000) ==
        "PointCloud2 message with more than 4 million points");
}

TEST_CASE("a cloud without x, y and z as real numbers is refused in words") {
  const std::string words = "PointCloud2 message without x, y and z as FLOAT32 or FLOAT64";
  CHECK(complaint_about({}, 1, 1, 12, 12, 12) == words);
  CHECK(complaint_about({kXyz[0], kXyz[1]}, 1, 1, 12, 12, 12) == words);
  CHECK(complaint_about({kXyz[0], kXyz[1], {"z", 8, 5}}, 1, 1, 12, 12, 12) == words);
  CHECK(complaint_about({kXyz[0], kXyz[1], {"z", 8, 255}}, 1, 1, 12, 12, 12) == words);
}

TEST_CASE("times of points are understood in the units of drivers") {
  struct Driver {
    std::string name;
    std::uint8_t type;
    double first, last, first_after_stamp_s;
  };
  const double stamp_s = 1'700'000'000.5;
  const std::vector<Driver> drivers{
      {"t", kUint32, 0, 99'000'000, 0},                                    // nanoseconds since the stamp
      {"offset_time", kUint32, 0, 99'000, 0},                              // microseconds
      {"time", kFloat32, -0.099, 0, -0.099},                               // seconds; stamped at the end
      {"timestamp", kFloat64, stamp_s, stamp_s + 0.099, 0},                // since 1970
      {"timestamp", kFloat64, stamp_s * 1e9, (stamp_s + 0.099) * 1e9, 0},  // the same in nanoseconds
      {"timestamp", kFloat64, stamp_s * 1e6, (stamp_s + 0.099) * 1e6, 0}};
  for (const Driver& driver : drivers) {
    INFO(driver.name << ", from " << driver.first);
    CloudMessage made = four_points();
    made.stamp_s = stamp_s;
    made.time_name = driver.name;
    made.time_type = driver.type;
    made.points.front().time = driver.first;
    for (std::size_t i = 1; i < 4; ++i) made.points[i].time = driver.last;
    const std::string message = made.bytes();
    const DecodedPointCloud decoded = decode_point_cloud(view(message), Wire::cdr);
    REQUIRE(decoded.cloud);
    const PointTimes times(*decoded.cloud);
    REQUIRE(times.are_known());
    CHECK(times.span_s() == Approx(0.099).margin(1e-5));
    CHECK(times.after_stamp_s(decoded.cloud->point(0).time) == Approx(driver.first_after_stamp_s).margin(1e-5));
  }
}

TEST_CASE("times that cannot be are not used") {
  CloudMessage made = four_points();
  made.time_name = "timestamp";
  made.time_type = kFloat64;
  made.points[0].time = 55;
  made.points[1].time = 5e10;
  const std::string message = made.bytes();
  const DecodedPointCloud decoded = decode_point_cloud(view(message), Wire::cdr);
  REQUIRE(decoded.cloud);
  CHECK_FALSE(PointTimes(*decoded.cloud).are_known());
}
