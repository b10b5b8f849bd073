// The contracts themselves: small offenders, each of which breaks one promise. Scorers are in
// scorer_violations_test.cpp.
#include "tests/plugin/contract/sentences.hpp"

#include <opal/plugin/testing/detector_contract.hpp>
#include <opal/plugin/testing/matcher_contract.hpp>
#include <opal/plugin/testing/pattern_contract.hpp>
#include <opal/plugin/testing/plugin_contract.hpp>
#include <opal/plugin/testing/reader_contract.hpp>

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <atomic>
#include <functional>
#include <limits>

using namespace opal;
using Catch::Contains;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

struct Detector final : FeatureDetector {
  std::function<std::vector<Feature>(const Scan&)> find;
  std::vector<Feature> detect(const Scan& scan) const override { return find(scan); }
};

Feature post(const Point& position) {
  Feature feature;
  feature.type = "acme:Post";
  feature.geometry = position;
  feature.covariance.topLeftCorner<2, 2>() = 1e-4 * Eigen::Matrix2d::Identity();
  return feature;
}

/// An honest detector: the nearest point of the scan.
std::vector<Feature> nearest(const Scan& scan) {
  const ScanPoint* best = nullptr;
  for (const ScanPoint& point : scan.points)
    if (point.position.allFinite() && (best == nullptr || point.range_m < best->range_m)) best = &point;
  return best == nullptr ? std::vector<Feature>{} : std::vector<Feature>{post(best->position)};
}

std::vector<std::string> detector_offences(std::function<std::vector<Feature>(const Scan&)> find) {
  Detector detector;
  detector.find = std::move(find);
  return testing::detector_violations(detector, {"acme:PostDetector", {}, {"acme:Post"}});
}

/// The honest detector with each feature changed.
std::vector<std::string> detector_offences_with(std::function<void(Feature&)> change) {
  return detector_offences([change = std::move(change)](const Scan& scan) {
    std::vector<Feature> features = nearest(scan);
    for (Feature& feature : features) change(feature);
    return features;
  });
}

struct Pattern final : PatternTemplate {
  std::function<std::optional<PatternInstance>(const Circle&, const Circle&)> relate;
  PatternShape shape() const override { return {{GeometryKind::circle, GeometryKind::circle}, 5.0}; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
    return relate(std::get<Circle>(features[0]->geometry), std::get<Circle>(features[1]->geometry));
  }
};

/// An honest pattern: two columns, the greater one first.
std::optional<PatternInstance> column_pair(const Circle& a, const Circle& b) {
  const Point way = b.center - a.center;
  if (!(a.radius_m > b.radius_m) || !(way.norm() > 0)) return std::nullopt;
  PatternInstance instance;
  instance.members = {0, 1};
  instance.invariants = {{way.norm(), 0.1, Comparison::equal}, {a.radius_m, 0.05, Comparison::equal}};
  instance.frame = {a.center, std::atan2(way.y(), way.x())};
  return instance;
}

std::vector<std::string> pattern_offences(
    std::function<std::optional<PatternInstance>(const Circle&, const Circle&)> relate) {
  Pattern pattern;
  pattern.relate = std::move(relate);
  return testing::pattern_violations(pattern, {"acme:ColumnPair", {"acme:Column"}, {}});
}

std::vector<std::string> pattern_offences_with(std::function<void(PatternInstance&, const Circle&)> change) {
  return pattern_offences([change = std::move(change)](const Circle& a, const Circle& b) {
    auto instance = column_pair(a, b);
    if (instance) change(*instance, a);
    return instance;
  });
}

}  // namespace

TEST_CASE("an honest detector of a type that the framework does not know breaks no promise") {
  CHECK(text(detector_offences(nearest)) == "");
}

TEST_CASE("a detector that breaks a promise is told which") {
  CHECK_THAT(text(detector_offences([](const Scan&) -> std::vector<Feature> { throw std::runtime_error("no luck"); })),
             Contains("acme:PostDetector throws on an empty scan: no luck"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.type = "acme:Door"; })),
             Contains("of type \"acme:Door\", but it does not say that it produces these"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.geometry = Point(kNan, 0); })),
             Contains("is no possible shape"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) {
               f.geometry = Circle{{0, 0}, -1};
             })),
             Contains("is no possible shape"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance(0, 1) = kNan; })),
             Contains("has a covariance that is not finite"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance.setZero(); })),
             Contains("without a positive variance for each of its numbers"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance(0, 1) = f.covariance(1, 0) = 1; })),
             Contains("with a negative eigenvalue"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance(2, 2) = 1; })),
             Contains("numbers in its unused third row"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.geometry = Point(1, 0); })),
             Contains("but not its like in example scan 0, turned by"));
}

TEST_CASE("a detector that remembers is told so") {
  auto calls = std::make_shared<std::atomic<int>>(0);
  CHECK_THAT(text(detector_offences_with([calls](Feature& f) { f.support_m = ++*calls; })),
             Contains("finds different features when it sees example scan 0 again; likely cause: a member that"));
}

TEST_CASE("a detector that must find something is told when it does not") {
  Detector detector;
  detector.find = [](const Scan&) { return std::vector<Feature>{}; };
  testing::DetectorTrial trial;
  trial.must_find_something = true;
  CHECK(text(testing::detector_violations(detector, {"acme:Blind", {}, {"acme:Post"}}, trial)) ==
        "acme:Blind finds nothing in any of the 5 scans\n");
}

TEST_CASE("an honest pattern over a type that the framework does not know breaks no promise") {
  CHECK(text(pattern_offences(column_pair)) == "");
}

TEST_CASE("a pattern that breaks a promise is told which") {
  const auto add_position = [](PatternInstance& i, const Circle& a) { i.invariants[0].value += a.center.x(); };
  CHECK_THAT(text(pattern_offences_with(add_position)), Contains("has an invariant 0 that a rigid motion changes"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle&) { i.frame = Pose2(); })),
             Contains("has a frame that does not move rigidly"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle&) {
               i.members = {0, 0};
             })),
             Contains("whose members are not each feature once"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle&) { i.invariants[1].tolerance = kNan; })),
             Contains("with a tolerance of nan"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle& a) {
               if (a.radius_m > 0.3) i.invariants.pop_back();
             })),
             Contains("different numbers or comparisons of invariants"));
  CHECK_THAT(text(pattern_offences([](const Circle& a, const Circle& b) {
               return a.radius_m > b.radius_m ? column_pair(a, b) : column_pair(b, a);
             })),
             Contains("accepts a selection in two orders"));
  CHECK_THAT(text(pattern_offences([](const Circle&, const Circle&) { return std::nullopt; })),
             Contains("matches none of 3000 random selections"));
  CHECK_THAT(text(pattern_offences([](const Circle& a, const Circle& b) {
               return a.center.x() < b.center.x() ? column_pair(a, b) : std::nullopt;
             })),
             Contains("in one frame, but not in another"));
}

TEST_CASE("a matcher that claims what it cannot know is told so") {
  struct Sure final : ScanMatcher {
    ScanMatch match(std::span<const Point>, std::span<const Point>, const Pose2& guess,
                    const Eigen::Vector3d&) const override {
      return {guess, Eigen::Matrix3d::Identity(), 1, true};
    }
  };
  const std::string said = text(testing::matcher_violations(Sure(), {"acme:Sure", {}, {}}));
  CHECK_THAT(said, Contains("acme:Sure says that it has converged on two empty scans"));
  CHECK_THAT(said, Contains("says that it has converged on a scan of a room, but is 0.05") &&
                       Contains("expected at most 0.03 m and 0.015 rad; likely cause: the guess is returned"));
}

TEST_CASE("a reader that takes everything for its own is told so") {
  struct Taker final : LogSource {
    bool recognizes(const std::string&) const override { return true; }
    std::unique_ptr<LogReader> open(const std::string&) const override { throw ConfigError("no"); }
  };
  const std::string said = text(testing::log_source_violations(Taker(), {"acme:Taker", {}, {}}));
  CHECK_THAT(said, Contains("acme:Taker recognises a missing file as its own"));
  CHECK_THAT(said, Contains("refuses a missing file with an error of the wrong kind: no"));
}

TEST_CASE("a plugin that fails when it is called breaks its contract, with the file and the type named") {
  const std::string folder = std::string(OPAL_BAD_PLUGIN_DIR) + "/";
  CHECK_THAT(
      text(testing::plugin_violations(folder + "throws_in_detect.so")),
      Contains("throws_in_detect.so has a type that breaks its contract: bad:throws_in_detect throws on an empty "
               "scan: this detector fails on every scan"));
  CHECK_THAT(text(testing::plugin_violations(folder + "throws_in_match.so")),
             Contains("bad:throws_in_match throws on") && Contains("this pattern fails on every tuple"));
  CHECK_THAT(text(testing::plugin_violations(folder + "absent.so")),
             Contains("absent.so is refused: ") && Contains("there is no such file"));
}
