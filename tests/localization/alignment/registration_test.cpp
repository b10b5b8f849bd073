#include "localization/alignment/registration.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace opal;

namespace {

GeometryPair seen_from(const Pose2& T_map_local, const Geometry& mapped) {
  return {transformed(T_map_local.inverse(), mapped), mapped};
}

void check_pose(const Pose2& found, const Pose2& expected, double tolerance) {
  CHECK(distance_m(found, expected) < tolerance);
  CHECK(angle_between_rad(found, expected) < tolerance);
}

const Segment kSouth{{0, 0}, {8, 0}}, kEast{{8, 0}, {8, 5}}, kNorth{{8, 5}, {0, 5}};

}  // namespace

TEST_CASE("registration recovers the pose from two faces that are not parallel, seen in part") {
  const Pose2 truth(3.2, -1.5, 2.4);
  GeometryPair a = seen_from(truth, kSouth), b = seen_from(truth, kEast);
  a.local = transformed(truth.inverse(), Segment{{2, 0}, {5, 0}});  // parts of the walls
  b.local = transformed(truth.inverse(), Segment{{8, 1}, {8, 2}});
  const Registration found = register_geometry(std::vector{a, b});
  CHECK(found.fixed == 3);
  check_pose(found.T_map_local, truth, 1e-6);
}

TEST_CASE("registration recovers the pose from any two points, one corner, or a mixture") {
  const auto [x, y, heading] = GENERATE(table<double, double, double>({{0, 0, 0}, {5, -7, 3.1}, {-40, 12, -1.6}}));
  CAPTURE(x, y, heading);
  const Pose2 truth(x, y, heading);
  const Circle column{{2, 3}, 0.3}, other{{-4, 1}, 0.3};
  const OrientedPoint corner{{1, -2}, 0.7, 1.57};
  for (const auto& pairs :
       {std::vector{seen_from(truth, column), seen_from(truth, other)}, std::vector{seen_from(truth, corner)},
        std::vector{seen_from(truth, corner), seen_from(truth, kEast), seen_from(truth, column)}}) {
    const Registration found = register_geometry(pairs);
    CHECK(found.fixed == 3);
    check_pose(found.T_map_local, truth, 1e-6);
    for (double error : found.errors_m) CHECK(error < 1e-6);
  }
}

TEST_CASE("parallel faces leave the shift along them open and say so") {
  const Pose2 truth(1, 2, 0.5);
  const Registration found = register_geometry(std::vector{seen_from(truth, kSouth), seen_from(truth, kNorth)});
  CHECK(found.fixed == 2);
  CHECK(angle_between_rad(found.T_map_local, truth) < 1e-6);
  for (double error : found.errors_m) CHECK(error < 1e-6);
}

TEST_CASE("parallel faces at a wrong distance show the difference as errors") {
  GeometryPair south{kSouth, kSouth}, north{Segment{{8, 5.6}, {0, 5.6}}, kNorth};
  const Registration found = register_geometry(std::vector{south, north});
  CHECK(found.errors_m[0] == Approx(0.3).margin(0.02));
  CHECK(found.errors_m[1] == Approx(0.3).margin(0.02));
}

TEST_CASE("a part of a wall is as far from the wall as its offset and the gap along it say") {
  const Segment wall{{0, 0}, {4, 0}};
  CHECK(mismatch(Segment{{1, 0.3}, {2, 0.3}}, wall).position_m == Approx(0.3));
  CHECK(mismatch(Segment{{3, 0.3}, {6, 0.3}}, wall).position_m == Approx(0.3));
  CHECK(mismatch(Segment{{4.4, 0.3}, {6, 0.3}}, wall).position_m == Approx(0.5));
  CHECK(mismatch(Segment{{6, 0.3}, {4.4, 0.3}}, wall).position_m == Approx(0.5));
  CHECK(mismatch(Segment{{-2, 0.3}, {-0.4, 0.3}}, wall).position_m == Approx(0.5));
  CHECK(mismatch(Segment{{1, 0}, {1 + std::cos(0.2), std::sin(0.2)}}, wall).heading_rad == Approx(0.2));
}

TEST_CASE("registration of nothing fixes nothing") { CHECK(register_geometry({}).fixed == 0); }

TEST_CASE("registration moves rigidly with the map and with the local frame") {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.03);
  const Pose2 truth(2, 1, 0.4), moved(-7, 3, 1.9);
  std::vector<GeometryPair> pairs, moved_pairs;
  for (const Segment& face : {kSouth, kEast, kNorth}) {
    GeometryPair pair = seen_from(truth, face);
    auto& local = std::get<Segment>(pair.local);
    local.begin += Point{noise(random), noise(random)};
    local.end += Point{noise(random), noise(random)};
    pairs.push_back(pair);
    moved_pairs.push_back({pair.local, transformed(moved, pair.mapped)});
  }
  check_pose(register_geometry(moved_pairs).T_map_local, moved * register_geometry(pairs).T_map_local, 1e-6);
}
