// What several views of one thing say of it together.
#include "local_map/local_map_merging.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;

namespace {

const Eigen::Matrix3d kDetected = Eigen::Vector3d(4e-4, 9e-4, 1e-4).asDiagonal();
// What the pose of a keyframe adds: 2 cm and 5 mrad.
constexpr double kPose_m2 = 4e-4, kPose_rad2 = 2.5e-5;

Feature column(double x_m, double y_m) { return {"opal:Column", Circle{{x_m, y_m}, 0.2}, kDetected}; }
Feature corner(double x_m, double y_m, double heading_rad, double opening_rad = 1.5) {
  return {"opal:Corner", OrientedPoint{{x_m, y_m}, heading_rad, opening_rad}, kDetected};
}
Feature point(double x_m, double y_m) { return {"opal:Point", Point(x_m, y_m), kDetected}; }
Feature piece(const Point& begin, const Point& end, double covered = 1) {
  Feature piece{"opal:Wall", Segment{begin, end}, kDetected};
  piece.support_m = covered * (end - begin).norm();
  return piece;
}

/// The estimate of views, each from a keyframe of its own, all at one pose.
Feature seen(const std::vector<Feature>& views, const Pose2& T_local_base = {}) {
  std::vector<Measurement> measurements;
  std::deque<Keyframe> keyframes;
  for (const Feature& view : views) {
    const KeyframeId id(keyframes.size());
    keyframes.push_back({id, 0, T_local_base, {}, 0, {}});
    measurements.push_back({id, view});
  }
  return estimate(measurements, keyframes, {});
}

Eigen::Vector3d variances(const Feature& feature) { return feature.covariance.diagonal(); }
/// The most of what differs [m, rad].
double apart(const Geometry& a, const Geometry& b) {
  if (const auto* face = std::get_if<Segment>(&a))
    return std::max((face->begin - std::get<Segment>(b).begin).norm(), (face->end - std::get<Segment>(b).end).norm());
  const double apart_m = (anchor_of(a) - anchor_of(b)).norm();
  const auto* corner = std::get_if<OrientedPoint>(&a);
  if (!corner) return apart_m;
  return std::max(apart_m, std::abs(wrap_angle(corner->heading_rad - std::get<OrientedPoint>(b).heading_rad)));
}
const Segment& face_of(const Feature& feature) { return std::get<Segment>(feature.geometry); }

}  // namespace

TEST_CASE("one view is what it is, but for the error of the pose from which it was taken") {
  CHECK(variances(seen({column(3, 1)}))
            .isApprox(Eigen::Vector3d(4e-4, 9e-4, 1e-4) + Eigen::Vector3d::Constant(kPose_m2)));
  CHECK(variances(seen({corner(3, 1, 0.5)}))
            .isApprox(Eigen::Vector3d(4e-4 + kPose_m2, 9e-4 + kPose_m2, 1e-4 + kPose_rad2)));
  CHECK(variances(seen({point(3, 1)})).isApprox(Eigen::Vector3d(4e-4 + kPose_m2, 9e-4 + kPose_m2, 0)));
  const Feature face = seen({piece({3, -2}, {3, 5})});
  CHECK(variances(face).isApprox(Eigen::Vector3d(4e-4 + kPose_m2, 9e-4 + kPose_rad2, 0)));
  CHECK(std::abs(face.covariance(0, 1)) < 1e-12);
}

TEST_CASE("so many equal views are as much surer, whatever is seen") {
  for (const Feature& view : {column(3, 1), corner(3, 1, 0.5), point(3, 1), piece({3, -2}, {3, 5})}) {
    CAPTURE(view.type);
    const Feature one = seen({view}), five = seen({view, view, view, view, view});
    CHECK((5 * five.covariance).isApprox(one.covariance));
    CHECK(apart(one.geometry, five.geometry) < 1e-9);
  }
}

TEST_CASE("views that differ by little meet in the middle, headings and openings, too, also where headings wrap") {
  const auto mean = std::get<OrientedPoint>(seen({corner(3, 1, 3.14, 1.5), corner(3.002, 1.004, -3.14, 1.6)}).geometry);
  CHECK((mean.position - Point(3.001, 1.002)).norm() < 2e-4);
  CHECK(std::abs(wrap_angle(mean.heading_rad - std::numbers::pi)) < 2e-4);
  CHECK(mean.opening_rad == Approx(1.55));
  CHECK(std::get<Point>(seen({point(3, 1), point(3.002, 1)}).geometry).x() == Approx(3.001).margin(1e-4));
}

TEST_CASE("a view of before that is far off hardly moves what the others agree on") {
  const Feature well = column(3, 1), off = column(3.5, 1);
  for (const auto& views : {std::vector{off, well, well, well}, std::vector{well, well, off, well}})
    CHECK(std::get<Circle>(seen(views).geometry).center.x() < 3.02);
  const Feature face = piece({0, 2}, {4, 2}), bent = piece({1, 2.5}, {3, 2.5});
  CHECK(std::abs(face_of(seen({bent, face, face, face})).midpoint().y() - 2) < 0.02);
}

TEST_CASE("an estimate moves and turns with the poses of its keyframes") {
  const Pose2 moved(2, -1, 1.2);
  const std::vector<std::vector<Feature>> all{{column(3, 1), column(3.05, 1)},
                                              {corner(3, 1, 0.5), corner(3.02, 1, 0.6)},
                                              {piece({0, 2}, {2, 2}), piece({1.5, 2.02}, {5, 2.05})}};
  for (const auto& views : all) {
    const Feature here = seen(views), there = seen(views, moved);
    CHECK(apart(transformed(moved, here.geometry), there.geometry) < 1e-6);
    CHECK((transformed(moved, here).covariance - there.covariance).norm() < 1e-6 * here.covariance.norm());
  }
}

TEST_CASE("the offset of a wall is known worse the farther its middle lies from what was seen of it") {
  const Feature face = piece({0, 2}, {4, 2});
  Feature beyond = piece({4, 2}, {9, 2});
  beyond.covariance = 1e6 * kDetected;  // it is hardly known where
  beyond.true_end = {false, true};
  const Feature whole = seen({face, beyond});
  CHECK(face_of(whole).length_m() == Approx(9));
  const double lever_m = 4.5 - 2, offset_m2 = 4e-4 + kPose_m2, heading_rad2 = 9e-4 + kPose_rad2;
  CHECK(whole.covariance(0, 0) == Approx(offset_m2 + lever_m * lever_m * heading_rad2).epsilon(1e-3));
  CHECK(whole.covariance(0, 1) == Approx(lever_m * heading_rad2).epsilon(1e-3));
  CHECK(whole.true_end == std::array<bool, 2>{false, true});
}

TEST_CASE("support is what the pieces cover together, each stretch once") {
  CHECK(seen({piece({0, 2}, {4, 2}), piece({3, 2}, {6, 2})}).support_m == Approx(6));
  CHECK(seen({piece({0, 2}, {4, 2}), piece({1, 2}, {2, 2})}).support_m == Approx(4));
  CHECK(seen({piece({0, 2}, {2, 2}), piece({5, 2}, {6, 2})}).support_m == Approx(3));  // nothing was seen in between
  CHECK(seen({piece({0, 2}, {4, 2}, 0.5), piece({0, 2}, {4, 2}, 0.5)}).support_m == Approx(2));
}

TEST_CASE("pieces that others bridge become one wall, in whatever order they are seen") {
  std::vector<int> order{0, 1, 2, 3};
  const std::vector<Feature> pieces{piece({0, 2}, {1, 2}), piece({1.2, 2}, {1.8, 2}), piece({2, 2}, {3, 2}),
                                    piece({3.2, 2}, {5, 2})};
  do {
    std::vector<Feature> detected;
    for (const int k : order) detected.push_back(pieces[static_cast<std::size_t>(k)]);
    LocalMap map({}, nullptr);
    map.add(sample_of({}, Pose2()), detected);
    CHECK(map.features().size() == 1);
    CHECK(map.last_associations() == std::vector<LocalFeatureId>(4, LocalFeatureId(0)));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("a wall stays stable when a piece that is not joins it, though the poses of both differ by less in turn") {
  LocalMapOptions options;
  options.horizon_m = 100;
  options.optimize_every = 0;
  LocalMap map(options, nullptr);
  const auto see_from = [&](double x_m, double begin_m, double end_m) {
    map.add(sample_of({}, Pose2(x_m, 0, 0)), {piece({begin_m - x_m, 2}, {end_m - x_m, 2})});
    map.add(sample_of({}, Pose2(x_m + 1, 0, 0)), {});
  };
  see_from(0, 0, 2);
  for (const double x_m : {0.03, -0.03, 0.03}) see_from(x_m, 5, 7);
  REQUIRE(map.features().size() == 2);
  REQUIRE((!map.features()[0].stable && map.features()[1].stable));
  see_from(0, 1.8, 5.2);
  REQUIRE(map.features().size() == 1);
  CHECK(map.features()[0].stable);
}
