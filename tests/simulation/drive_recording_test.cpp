#include "simulation/drives/drive_recording.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::simulation;

namespace {

RawScan scan_at(double stamp_s) {
  RawScan scan;
  scan.stamp_s = stamp_s;
  return scan;
}

}  // namespace

TEST_CASE("drives follow each other in one recording, and the one that goes on is left out") {
  DriveRecording recording(SimulationOptions::default_laser());
  CHECK(recording.ended().scans.empty());
  for (const double stamp_s : {0.0, 1.0, 2.0}) recording.witness(scan_at(stamp_s), {stamp_s, 0, 0});
  recording.end_drive(7, 2);
  for (const double stamp_s : {0.0, 1.0}) recording.witness(scan_at(stamp_s), {5, stamp_s, 0});
  CHECK(recording.ended().scans.size() == 3);
  recording.end_drive(8, 1);
  const Recording both = recording.ended();
  REQUIRE(both.scans.size() == 5);
  REQUIRE(both.queries.size() == 2);
  CHECK(both.queries[0].id == "s7");
  CHECK(both.queries[0].end_s == 2);
  CHECK(both.queries[1].start_s > both.queries[0].end_s);
  CHECK(both.scans[3].scan.stamp_s == both.queries[1].start_s);
  CHECK(both.scans[4].T_map_base.y() == 1);
  CHECK(both.distances_m == std::vector<double>{2, 1});
}
