// What a slice of a point cloud costs.
#include "recording/cloud_slicer.hpp"
#include "tests/recording/clouds/cloud_message.hpp"

#include <catch2/catch.hpp>

#include <span>

using namespace opal;
using namespace opal::recording;

TEST_CASE("a slice of a cloud of 128 rings with 1,024 points each", "[!benchmark][live][cloud]") {
  constexpr std::uint32_t kRings = 128, kColumns = 1024;
  recording_tests::CloudMessage made;
  made.height = kRings;
  made.time_name = "t";
  for (std::uint32_t ring = 0; ring < kRings; ++ring)
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double bearing_rad = 2 * std::numbers::pi * column / kColumns, rise_rad = 0.4 * (ring / 64.0 - 1);
      const Point on_floor = 5 * unit_vector(bearing_rad);
      made.points.push_back({on_floor.x(), on_floor.y(), 5 * std::tan(rise_rad), 1e5 * column});
    }
  const std::string message = made.bytes();
  LaserModel laser;
  laser.beams = 720;
  laser.angle_min_rad = -std::numbers::pi;
  laser.angle_increment_rad = 2 * std::numbers::pi / laser.beams;
  laser.slice = CloudSlice{0.3, 1.8, 1, 0, 0};
  const CloudSlicer slicer(laser);
  BENCHMARK("decode and slice 131,072 points") {
    const DecodedPointCloud decoded = decode_point_cloud(std::as_bytes(std::span(message)), Wire::cdr);
    return slicer.scan_of(*decoded.cloud).ranges_m.size();
  };
}
