#include "localization/alignment/pose_filter.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <random>

using namespace opal;

namespace {

constexpr double kPoints = 100;

/// What a scan of a room with walls on all sides says.
Alignment seen_from_all_sides(const Pose2& T_map_base) {
  return {T_map_base, Eigen::Vector3d(kPoints / 2, kPoints / 2, 5 * kPoints).asDiagonal(),
          Eigen::Vector3d(1, 1, 10).asDiagonal()};
}

/// What a scan of two long walls along x says: nothing about x.
Alignment seen_in_corridor(const Pose2& T_map_base) {
  return {T_map_base, Eigen::Vector3d(0, kPoints, 5 * kPoints).asDiagonal(), Eigen::Vector3d(1, 1, 10).asDiagonal()};
}

/// A filter that has seen a room from `T_map_base` for some metres.
PoseFilter settled_at(const Pose2& T_map_base) {
  PoseFilter filter;
  for (int k = 0; k < 10; ++k) filter.update({T_map_base, T_map_base}, seen_from_all_sides(T_map_base), 1, {});
  return filter;
}

Pose2 shifted(const Pose2& pose, double x_m, double y_m) {
  return {pose.x() + x_m, pose.y() + y_m, pose.heading_rad()};
}

/// The pose of a robot that stands, after twenty scans of so much tempering_weight that lie elsewhere.
Pose2 after_twenty(const Pose2& known, const Pose2& elsewhere, double tempering_weight) {
  PoseFilter filter = settled_at(known);
  Pose2 pose = known;
  for (int k = 0; k < 20; ++k)
    pose = filter.update({pose, known}, seen_from_all_sides(elsewhere), tempering_weight, {});
  return pose;
}

}  // namespace

TEST_CASE("the first scan alone says where a hypothesis is, and so does the first after a reset") {
  PoseFilter filter = settled_at({0, 0, 0});
  const Pose2 scan(3, 4, 0.5);
  filter.reset();
  const Pose2 found = filter.update({{2.8, 4, 0.4}, scan}, seen_from_all_sides(scan), 1, {});
  CHECK(distance_m(found, scan) < 0.002);
  CHECK(angle_between_rad(found, scan) < 0.003);
}

TEST_CASE("one scan that lies elsewhere moves a pose that many agree on only a little") {
  const Pose2 known(1, 2, 0.3);
  PoseFilter filter = settled_at(known);
  const Pose2 found = filter.update({known, known}, seen_from_all_sides(shifted(known, 0.1, 0)), 1, {});
  CHECK(found.x() > known.x());
  CHECK(found.x() < known.x() + 0.03);
}

TEST_CASE("scans that keep lying elsewhere are followed in the end") {
  const Pose2 known(1, 2, 0.3), elsewhere = shifted(known, 0.1, 0);
  CHECK(distance_m(after_twenty(known, elsewhere, 1), elsewhere) < 0.01);
}

TEST_CASE("a robot that stands does not creep to where one scan puts it, however often it sees it") {
  const Pose2 known(1, 2, 0.3), elsewhere = shifted(known, 0.1, 0);
  CHECK(distance_m(after_twenty(known, elsewhere, 0.01), known) < 0.03);
}

TEST_CASE("what a corridor does not say, it does not move, and where it was entered stays known") {
  const Pose2 known(1, 2, 0);
  PoseFilter filter = settled_at(known);
  Pose2 pose = known;
  for (int k = 0; k < 10; ++k) {
    const Pose2 predicted = shifted(pose, 1, 0);
    // Nothing holds the scan along the corridor: it slides a hand's breadth each time.
    pose = filter.update({predicted, predicted}, seen_in_corridor(shifted(predicted, 0.05, 0)), 1, {});
  }
  CHECK(pose.y() == Approx(2).margin(1e-9));
  CHECK(std::abs(pose.x() - 11) < 0.2);  // half a metre, if each scan stood alone
}

TEST_CASE("an alignment far from where dead reckoning predicts it is followed: dead reckoning has failed") {
  const Pose2 known(1, 2, 0.3), far = shifted(known, 1.5, 0);
  PoseFilter filter = settled_at(known);
  CHECK(distance_m(filter.update({known, known}, seen_from_all_sides(far), 1, {}), far) < 0.01);
}

TEST_CASE("without memory, every scan stands alone") {
  const Pose2 known(1, 2, 0.3), elsewhere = shifted(known, 0.1, 0.05);
  PoseFilter filter;
  for (const Pose2& seen : {known, elsewhere, known}) {
    const Pose2 found = filter.update({known, known}, seen_from_all_sides(seen), 1, {.memory = 0});
    CHECK(distance_m(found, seen) < 1e-12);
  }
}

TEST_CASE("a heading that is poorly known leaves more room to the side the further the robot has driven") {
  const auto side_step_after = [](double driven_m) {
    PoseFilter filter;
    const Alignment column{Pose2(), Eigen::Vector3d(50, 50, 1).asDiagonal(), Eigen::Vector3d(1, 1, 1).asDiagonal()};
    filter.update({}, column, 1, {});
    const Pose2 predicted(driven_m, 0, 0);
    const Alignment aside{shifted(predicted, 0, 0.05), column.by_points, column.by_guess};
    return filter.update({predicted, predicted}, aside, 1, {}).y();
  };
  CHECK(side_step_after(10) > 1.2 * side_step_after(0.1));
}

TEST_CASE("a filter in a rigidly moved map says the rigidly moved poses") {
  const Pose2 moved(7, -3, 2.2);
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 0.03);
  PoseFilter here, there;
  Pose2 pose_here(1, 2, 0.3), pose_there = moved * pose_here, T_local_base;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(2.2), -std::sin(2.2), std::sin(2.2), std::cos(2.2);
  for (int k = 0; k < 20; ++k) {
    const Pose2 step(0.5, 0, 0.1);
    const Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 0.002, 0.001).asDiagonal();
    T_local_base = T_local_base * step;
    const Pose2 predicted = pose_here * step, scan = predicted * Pose2{noise(random), noise(random), noise(random)};
    const Alignment seen = k % 2 == 0 ? seen_from_all_sides(scan) : seen_in_corridor(scan);
    pose_here = here.update({predicted, T_local_base, covariance}, seen, 0.4, {});
    const Alignment seen_there{moved * scan, turn * seen.by_points * turn.transpose(),
                               turn * seen.by_guess * turn.transpose()};
    pose_there = there.update({pose_there * step, T_local_base, covariance}, seen_there, 0.4, {});
    INFO("update " << k);
    CHECK(distance_m(pose_there, moved * pose_here) < 1e-9);
    CHECK(angle_between_rad(pose_there, moved * pose_here) < 1e-9);
  }
}

TEST_CASE("an alignment that is no number is handed on as it is, and does not spoil what is known") {
  const Pose2 known(1, 2, 0.3), elsewhere = shifted(known, 0.1, 0);
  PoseFilter filter = settled_at(known);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const Alignment spoilt{elsewhere, Eigen::Matrix3d::Constant(nothing), Eigen::Matrix3d::Zero()};
  CHECK(distance_m(filter.update({known, known}, spoilt, 1, {}), elsewhere) == 0);
  const Pose2 found = filter.update({known, known}, seen_from_all_sides(known), 1, {});
  CHECK(distance_m(found, known) < 1e-9);
}

TEST_CASE("a pose that was just found is known as well as a search finds it, wherever the robot has driven before") {
  const Eigen::Matrix3d found = PoseFilter().covariance();
  CHECK(std::sqrt(found(0, 0)) == Approx(0.3).margin(0.01));
  CHECK(std::sqrt(found(1, 1)) == Approx(0.3).margin(0.01));
  CHECK(std::sqrt(found(2, 2)) == Approx(0.05).margin(0.002));
  CHECK(std::abs(found(0, 1)) < 1e-9);
  PoseFilter filter;
  filter.update({Pose2(), Pose2(100, 50, 1)}, seen_from_all_sides(Pose2()), 0.01, {});
  CHECK(std::sqrt(filter.covariance()(0, 0)) < 0.35);
}

TEST_CASE("a pose that dead reckoning has lost is not stated more exactly than it is") {
  const Pose2 known(1, 2, 0.3), elsewhere = shifted(known, 0.8, 0);
  PoseFilter filter = settled_at(known);
  const auto sigma_m = [&] { return std::sqrt(filter.covariance()(0, 0)); };
  const double settled_m = sigma_m();
  Pose2 pose = known;
  for (int k = 0; k < 20; ++k) {
    pose = filter.update({pose, known}, seen_from_all_sides(elsewhere), 0.1, {});
    CAPTURE(k, distance_m(pose, elsewhere));
    CHECK(distance_m(pose, elsewhere) < 6 * sigma_m());
  }
  CHECK(distance_m(pose, elsewhere) < 0.1);
  CHECK(sigma_m() > settled_m);
}

TEST_CASE("what driving adds is not known: along a corridor the pose is lost slowly, across it never") {
  PoseFilter filter = settled_at({0, 0, 0});
  const Eigen::Matrix3d settled = filter.covariance();
  Pose2 pose, T_local_base;
  const Eigen::Matrix3d step = Eigen::Vector3d(0.01, 0.01, 1e-4).asDiagonal();
  for (int k = 0; k < 40; ++k) {
    T_local_base = T_local_base * Pose2(0.25, 0, 0);
    pose = filter.update({Pose2(pose.x() + 0.25, pose.y(), 0), T_local_base, step},
                         seen_in_corridor({pose.x() + 0.25, 0, 0}), 0.2, {});
  }
  CHECK(filter.covariance()(0, 0) > settled(0, 0) + 0.05);
  CHECK(filter.covariance()(1, 1) < settled(1, 1) + 0.005);
}

TEST_CASE("a drive along the axes of the local frame is doubted along the way it takes on the map") {
  PoseFilter filter = settled_at({0, 0, 1.57});
  const Eigen::Matrix3d along = Eigen::Vector3d(0.3, 0, 0).asDiagonal();
  filter.update({Pose2(0, 1, 1.57), Pose2(1, 0, 0), along}, {Pose2(0, 1, 1.57)}, 0.2, {});
  CHECK(filter.covariance()(1, 1) > 3 * filter.covariance()(0, 0));
}
