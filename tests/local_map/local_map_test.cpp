#include <opal/local_map/local_map.hpp>

#include <catch2/catch.hpp>

#include <limits>

using namespace opal;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Eigen::Matrix3d covariance(double x, double y, double z) { return Eigen::Vector3d(x, y, z).cwiseAbs2().asDiagonal(); }

Feature wall(const Point& begin, const Point& end, bool true_begin = false, bool true_end = false) {
  return {"opal:Wall", Segment{begin, end}, covariance(0.01, 0.01, 0), {true_begin, true_end}, (end - begin).norm()};
}

Feature pillar(const Point& center, double radius_m) {
  return {"opal:Pillar", Circle{center, radius_m}, covariance(0.02, 0.02, 0.01), {}, 0};
}

/// Adds what a robot at `T_local_base` with perfect odometry detects of `world` (in frame local).
void see(LocalMap& map, const Pose2& T_local_base, const std::vector<Feature>& world) {
  std::vector<Feature> detected;
  for (const Feature& feature : world) detected.push_back(transformed(T_local_base.inverse(), feature));
  map.add(sample_of({}, T_local_base), detected);
}

LocalMapOptions without_graph() {
  LocalMapOptions options;
  options.optimize_every = 0;
  return options;
}

std::vector<LocalFeatureId> ids(std::initializer_list<int> numbers) {
  std::vector<LocalFeatureId> ids;
  for (const int number : numbers) ids.emplace_back(number);
  return ids;
}

const Segment& segment_of(const LocalFeature& local) { return std::get<Segment>(local.feature.geometry); }

/// Gives the same answer whatever it is asked.
struct FixedMatcher : ScanMatcher {
  ScanMatch answer;
  ScanMatch match(std::span<const Point>, std::span<const Point>, const Pose2&, const Eigen::Vector3d&) const override {
    return answer;
  }
};

Scan scan_of(const std::vector<Point>& points) {
  Scan scan;
  for (const Point& p : points) scan.points.push_back({p, p.norm(), std::atan2(p.y(), p.x()), 0});
  return scan;
}

}  // namespace

TEST_CASE("the local frame starts at the first pose, wherever odometry starts") {
  LocalMap map({}, nullptr);
  map.add(sample_of({}, Pose2(12, -7, 2.5)), {});
  CHECK(map.T_local_base().position().norm() == Approx(0).margin(1e-12));
  CHECK(map.T_local_base().heading_rad() == Approx(0).margin(1e-12));
  map.add(sample_of({}, Pose2(12, -7, 2.5) * Pose2(1, 0.5, 0.3)), {});
  CHECK(map.T_local_base().x() == Approx(1));
  CHECK(map.T_local_base().y() == Approx(0.5));
  CHECK(map.T_local_base().heading_rad() == Approx(0.3));
  const Pose2 between = map.T_local_base_at(Pose2(12, -7, 2.5) * Pose2(2, 0.5, 0.3));
  CHECK(between.x() == Approx(2));
}

TEST_CASE("a feature seen again keeps its id and becomes stable after views from enough poses") {
  LocalMap map(without_graph(), nullptr);
  const std::vector<Feature> world{pillar({3, 1}, 0.2), wall({5, -2}, {5, 2})};
  see(map, Pose2(), world);
  REQUIRE(map.last_associations().size() == 2);
  const auto first = map.last_associations();
  CHECK(first[0] != first[1]);
  for (int step = 1; step <= 2; ++step) {
    CHECK_FALSE(map.features()[0].stable);
    see(map, Pose2(0.2 * step, 0, 0.1), world);
    CHECK(map.last_associations() == first);
  }
  REQUIRE(map.features().size() == 2);
  for (const LocalFeature& local : map.features()) {
    CHECK(local.distinct_poses == 3);
    CHECK(local.stable);
  }
}

TEST_CASE("a robot that stands still makes nothing stable and does not fill the map") {
  LocalMap map({}, nullptr);
  for (int i = 0; i < 500; ++i) see(map, Pose2(1e-4 * (i % 2), 0, 0), {pillar({3, 1}, 0.2)});
  REQUIRE(map.features().size() == 1);
  CHECK(map.features()[0].id == LocalFeatureId(0));
  CHECK(map.features()[0].distinct_poses == 1);
  CHECK_FALSE(map.features()[0].stable);
  CHECK(map.keyframes().size() <= 2);
}

TEST_CASE("slow driving keeps only keyframes that differ") {
  LocalMapOptions options;
  LocalMap map(options, nullptr);
  for (int i = 0; i < 400; ++i) see(map, Pose2(0.005 * i, 0, 0), {pillar({3, 1}, 0.2)});
  CHECK(map.keyframes().size() >= 2 / 0.06);
  CHECK(map.keyframes().size() <= 2 / 0.05 + 2);
  CHECK(map.keyframes().back().driven_m == Approx(0.005 * 399).margin(1e-6));
}

TEST_CASE("features of another type, shape, size or side are other features") {
  LocalMap map(without_graph(), nullptr);
  const std::vector<Feature> first{pillar({3, 0}, 0.2), wall({0, 2}, {4, 2})};
  see(map, Pose2(), first);
  Feature renamed = first[0];
  renamed.type = "acme:Barrel";
  see(map, Pose2(), {renamed, pillar({3, 0}, 0.5), wall({4, 2}, {0, 2}), wall({1, 2.5}, {3, 2.5})});
  for (const LocalFeatureId id : map.last_associations()) CHECK(id >= LocalFeatureId(2));
}

TEST_CASE("two near circles are not mixed up, whichever is detected first") {
  LocalMap map(without_graph(), nullptr);
  see(map, Pose2(), {pillar({3, 0}, 0.2), pillar({3, 0.25}, 0.2)});
  const auto first = map.last_associations();
  REQUIRE(first[0] != first[1]);
  see(map, Pose2(0.1, 0, 0), {pillar({3, 0.27}, 0.2), pillar({3, 0.02}, 0.2)});
  CHECK(map.last_associations() == std::vector<LocalFeatureId>{first[1], first[0]});
}

TEST_CASE("a circle seen again and again stands at the mean of its views") {
  LocalMap map(without_graph(), nullptr);
  int view = 0;
  for (const double x : {2.97, 3.03, 2.97, 3.03}) see(map, Pose2(0.5 * view++, 0, 0), {pillar({x, 2}, 0.3)});
  REQUIRE(map.features().size() == 1);
  const auto& circle = std::get<Circle>(map.features().front().feature.geometry);
  CHECK((circle.center - Point(3, 2)).norm() < 0.02);
  CHECK(circle.radius_m == Approx(0.3).margin(0.01));
}

TEST_CASE("partial segments are joined and reach as far as any piece") {
  LocalMap map(without_graph(), nullptr);
  see(map, Pose2(), {wall({0, 2}, {2, 2})});
  see(map, Pose2(0.2, 0, 0), {wall({1, 2}, {5, 2})});
  REQUIRE(map.features().size() == 1);
  CHECK(segment_of(map.features()[0]).begin.isApprox(Point(0, 2), 1e-6));
  CHECK(segment_of(map.features()[0]).end.isApprox(Point(5, 2), 1e-6));
  CHECK(map.features()[0].feature.support_m == Approx(5));
}

TEST_CASE("a piece that bridges two local segments makes them one, with the older id") {
  LocalMap map(without_graph(), nullptr);
  see(map, Pose2(), {wall({0, 2}, {1, 2}), wall({3, 2}, {4, 2})});
  REQUIRE(map.features().size() == 2);
  see(map, Pose2(0.2, 0, 0), {wall({0.5, 2}, {3.5, 2})});
  REQUIRE(map.features().size() == 1);
  CHECK(map.features()[0].id == LocalFeatureId(0));
  CHECK(map.last_associations() == ids({0}));
  CHECK(map.features()[0].measurements.size() == 3);
  CHECK(segment_of(map.features()[0]).length_m() == Approx(4));
}

TEST_CASE("a true end stays when later views end before it, and tells a gap from a doorway") {
  LocalMap map(without_graph(), nullptr);
  see(map, Pose2(), {wall({0, 2}, {2, 2}, false, true)});
  see(map, Pose2(0.2, 0, 0), {wall({0.5, 2}, {1.5, 2})});
  REQUIRE(map.features().size() == 1);
  CHECK(map.features()[0].feature.true_end == std::array<bool, 2>{false, true});
  CHECK(segment_of(map.features()[0]).end.x() == Approx(2));
  see(map, Pose2(0.4, 0, 0), {wall({2.2, 2}, {3, 2})});
  CHECK(map.features().size() == 2);
}

TEST_CASE("a true end that another view reaches beyond was none") {
  LocalMap map(without_graph(), nullptr);
  see(map, Pose2(), {wall({0, 2}, {2, 2}, false, true)});
  see(map, Pose2(0.2, 0, 0), {wall({1, 2}, {4, 2})});
  REQUIRE(map.features().size() == 1);
  CHECK(map.features()[0].feature.true_end[1] == false);
  CHECK(segment_of(map.features()[0]).end.x() == Approx(4));
}

TEST_CASE("what lies beyond the horizon is forgotten and its id is not used again") {
  LocalMapOptions options = without_graph();
  options.horizon_m = 2;
  LocalMap map(options, nullptr);
  see(map, Pose2(), {pillar({1, 1}, 0.2)});
  for (int i = 1; i <= 10; ++i) see(map, Pose2(0.5 * i, 0, 0), {});
  CHECK(map.features().empty());
  CHECK(map.keyframes().size() == 5);
  CHECK(map.keyframes().back().driven_m - map.keyframes().front().driven_m <= 2);
  see(map, Pose2(5, 0, 0), {pillar({1, 1}, 0.2)});
  CHECK(map.last_associations() == ids({1}));
}

TEST_CASE("turning on the spot ages the map, too") {
  LocalMap map({}, nullptr);
  for (int i = 0; i < 2000; ++i) see(map, Pose2(0, 0, 0.1 * i), {});
  CHECK(map.keyframes().size() <= 6.0 / (0.5 * 0.1) + 2);
}

TEST_CASE("clear forgets everything but the ids") {
  LocalMap map({}, nullptr);
  see(map, Pose2(3, 4, 1), {pillar({1, 1}, 0.2)});
  map.clear();
  CHECK(map.features().empty());
  CHECK(map.keyframes().empty());
  CHECK(map.last_associations().empty());
  see(map, Pose2(-3, 2, 0), {pillar({1, 1}, 0.2)});
  CHECK(map.features()[0].id == LocalFeatureId(1));
  CHECK(map.keyframes()[0].id == KeyframeId(1));
  CHECK(map.T_local_base().position().norm() == Approx(0).margin(1e-12));
}

TEST_CASE("what is kept alone keeps its id and its views, and what is seen again is new") {
  LocalMap map({}, nullptr);
  const std::vector<Feature> columns{pillar({3, 0}, 0.2), pillar({3, 3}, 0.2), pillar({0, 3}, 0.2)};
  for (int k = 0; k < 4; ++k) see(map, Pose2(0.1 * k, 0, 0), columns);
  map.keep_only(ids({1, 77}));
  REQUIRE(map.features().size() == 1);
  CHECK(map.features()[0].id == LocalFeatureId(1));
  CHECK(map.features()[0].stable);
  CHECK(map.keyframes().size() == 4);
  see(map, Pose2(0.4, 0, 0), columns);
  REQUIRE(map.features().size() == 3);
  CHECK(map.features()[0].id == LocalFeatureId(1));
  CHECK(map.features()[1].id == LocalFeatureId(3));
  CHECK_FALSE(map.features()[1].stable);
  map.keep_only({});
  CHECK(map.features().empty());
}

TEST_CASE("features, points and odometry that are not finite are left out") {
  LocalMap map({}, nullptr);
  see(map, Pose2(), {pillar({2, 0}, 0.2)});
  Feature no_covariance = pillar({2, 0}, 0.2);
  no_covariance.covariance(0, 0) = kNan;
  map.add(sample_of(scan_of({{kNan, 1}, {2, 2}}), Pose2(kNan, 0, 0)),
          {pillar({kNan, 0}, 0.2), wall({1, 1}, {1, 1}), no_covariance, pillar({2, 0}, 0.2)});
  CHECK(map.last_associations() == ids({-1, -1, -1, 0}));
  CHECK(map.keyframes().back().points.size() == 1);
  CHECK(map.T_local_base().position().norm() == Approx(0).margin(1e-12));
  map.add(sample_of({}, Pose2(1, 0, 0)), {});
  CHECK(map.T_local_base().x() == Approx(1));
}

TEST_CASE("a converged scan match replaces odometry, another one does not") {
  auto matcher = std::make_shared<FixedMatcher>();
  matcher->answer = {Pose2(0.9, 0.1, 0.02), Eigen::Matrix3d::Identity() * 1e-4, 0.9, true};
  LocalMap map(without_graph(), matcher);
  map.add(sample_of(scan_of({{1, 1}}), Pose2()), {});
  CHECK_FALSE(map.last_match().converged);
  map.add(sample_of(scan_of({{1, 1}}), Pose2(1, 0, 0)), {});
  CHECK(map.last_match().converged);
  CHECK(map.T_local_base().x() == Approx(0.9));
  matcher->answer.converged = false;
  map.add(sample_of(scan_of({{1, 1}}), Pose2(2, 0, 0)), {});
  CHECK((map.T_local_base().position() - Pose2(0.9, 0.1, 0.02) * Point(1, 0)).norm() < 1e-9);
}

TEST_CASE("the factor graph takes out an odometry error that the features contradict") {
  LocalMapOptions options;
  options.optimize_every = 1;
  const std::vector<Feature> world{wall({-1, 2}, {5, 2}), wall({5, 2}, {5, -2}), wall({5, -2}, {-1, -2}),
                                   pillar({3, 0.5}, 0.2)};
  LocalMap with(options, nullptr), without(without_graph(), nullptr);
  const Pose2 error(0.04, 0.03, 0.02);  // per step
  Pose2 T_odom_base;
  Pose2 truth;
  for (int i = 0; i < 6; ++i) {
    truth = Pose2(0.35 * i, 0.05 * i, 0.02 * i);
    T_odom_base = i == 0 ? truth : T_odom_base * Pose2(0.35, 0.05, 0.02) * error;
    std::vector<Feature> detected;
    for (const Feature& feature : world) detected.push_back(transformed(truth.inverse(), feature));
    with.add(sample_of({}, T_odom_base), detected);
    without.add(sample_of({}, T_odom_base), detected);
  }
  CAPTURE(distance_m(without.T_local_base(), truth), distance_m(with.T_local_base(), truth));
  CHECK(distance_m(with.T_local_base(), truth) < 0.15 * distance_m(without.T_local_base(), truth));
  CHECK(angle_between_rad(with.T_local_base(), truth) < 0.01);
  CHECK(with.features().size() == world.size());
}
