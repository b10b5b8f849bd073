#include "recorded_site.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>

using namespace opal;

namespace {

/// Localized scans of two replays of the same samples, one with its map moved by T_b_a: largest disagreement.
double worst_disagreement_m(const std::vector<ReplayedScan>& a, const std::vector<ReplayedScan>& b,
                            const Pose2& T_b_a) {
  double worst = 0;
  int both = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].estimate.status != Status::localized || b[k].estimate.status != Status::localized) continue;
    worst = std::max(worst, distance_m(T_b_a * a[k].estimate.T_map_base, b[k].estimate.T_map_base));
    ++both;
  }
  REQUIRE(both > 10);
  return worst;
}

class ThrowingScorer final : public HypothesisScorer {
 public:
  Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
    if (++calls_ % 3 == 0) throw std::runtime_error("every third call fails");
    return {};
  }

 private:
  mutable int calls_ = 0;
};

class ThrowingDetector final : public FeatureDetector {
 public:
  std::vector<Feature> detect(const Scan&) const override { throw std::runtime_error("never works"); }
};

}  // namespace

TEST_CASE("a rigidly moved map and odometry give the rigidly moved answer") {
  const RecordedSite site("malaga-demo");
  const Pose2 T_new_map(31.3, -7.7, GENERATE(0.7, -2.2)), T_new_odom(-4, 9, 2.1);
  CAPTURE(T_new_map.heading_rad());
  Localizer here(site.parts()), there(site.parts(moved_map(*site.map, T_new_map)));
  std::vector<Sample> moved = site.samples;
  for (Sample& sample : moved) sample.T_odom_base = T_new_odom * sample.T_odom_base;
  const auto a = replay(here, site.samples), b = replay(there, moved);
  // The lookup grid stays aligned with the axes of the map: differences of a fraction of its cells remain.
  CHECK(worst_disagreement_m(a, b, T_new_map) < 0.06);
}

TEST_CASE("the same samples give the same answer to the last bit, wherever memory lies") {
  const RecordedSite site("malaga-demo");
  Localizer one(site.parts()), other(site.parts());
  std::vector<std::unique_ptr<std::vector<char>>> in_the_way;
  const auto a = replay(one, site.samples);
  for (std::size_t k = 1; k < 2000; ++k) {
    in_the_way.push_back(std::make_unique<std::vector<char>>(k % 700 + 1));
    if (k % 3 == 0) in_the_way.erase(in_the_way.begin() + static_cast<std::ptrdiff_t>(in_the_way.size() / 2));
  }
  const auto b = replay(other, site.samples);
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    CHECK(a[k].estimate.T_map_base.x() == b[k].estimate.T_map_base.x());
    CHECK(a[k].estimate.T_map_base.heading_rad() == b[k].estimate.T_map_base.heading_rad());
    CHECK(a[k].estimate.probability == b[k].estimate.probability);
  }
}

TEST_CASE("the order of features in the map does not matter") {
  const RecordedSite site("malaga-demo");
  Localizer one(site.parts()), other(site.parts(reversed_map(*site.map)));
  CHECK(worst_disagreement_m(replay(one, site.samples), replay(other, site.samples), Pose2()) < 0.03);
}

TEST_CASE("the same log gives the same answer again") {
  const RecordedSite site("malaga-demo");
  Localizer localizer(site.parts()), other(site.parts());
  const auto first = replay(localizer, site.samples);
  localizer.reset();
  for (const auto& again : {replay(localizer, site.samples), replay(other, site.samples)})
    for (std::size_t k = 0; k < first.size(); ++k) {
      // The solver orders its sums by address, so the last bits may differ.
      CHECK(distance_m(first[k].estimate.T_map_base, again[k].estimate.T_map_base) < 1e-9);
      CHECK(first[k].estimate.probability == Approx(again[k].estimate.probability).margin(1e-9));
      CHECK(first[k].estimate.hypotheses == again[k].estimate.hypotheses);
    }
}

TEST_CASE("a scorer or detector that throws in the middle of a run is skipped and counted, and the run goes on") {
  const RecordedSite site("malaga-demo");
  LocalizerParts parts = site.parts();
  parts.scorers.push_back({"test:Throwing", std::make_shared<ThrowingScorer>(), ScorerRole::decides, 1.0});
  parts.detectors.push_back({"test:NeverWorks", std::make_shared<ThrowingDetector>()});
  Localizer faulty(parts), sound(site.parts());
  const auto a = replay(sound, site.samples), b = replay(faulty, site.samples);
  CHECK(worst_disagreement_m(a, b, Pose2()) < 1e-9);
  CHECK(faulty.plugin_failures().at("test:Throwing") > 10);
  const auto keyframes = std::count_if(b.begin(), b.end(), [](const ReplayedScan& s) { return s.keyframe; });
  CHECK(faulty.plugin_failures().at("test:NeverWorks") == keyframes);
}

TEST_CASE("poor scans are a status, and the robot is found again after them") {
  const RecordedSite site("malaga-demo");
  std::vector<Sample> samples = site.samples;
  for (std::size_t k = 5; k < 9; ++k) {  // blind for a while: nothing valid, nothing at all, one point, all free
    samples[k].views.front().scan.points.resize(k == 7 ? 1 : 0);
    samples[k].views.front().scan.free_bearings_rad.assign(k == 8 ? 361 : 0, 0.1);
  }
  Localizer localizer(site.parts());
  const auto scans = replay(localizer, samples);
  const auto truth = site.truth.T_map_laser_at(scans.back().stamp_s);
  REQUIRE(truth);
  CHECK(distance_m(*truth, scans.back().estimate.T_map_base * site.laser.T_base_laser) < 0.3);
}

TEST_CASE("a map of somewhere else never makes the robot localized") {
  const RecordedSite site("malaga-demo"), elsewhere("malaga");
  Localizer localizer(site.parts(elsewhere.map));
  for (const ReplayedScan& scan : replay(localizer, site.samples)) {
    CAPTURE(scan.stamp_s);
    CHECK(scan.estimate.status != Status::localized);
  }
}

namespace {

/// A scan as two lasers at the same place would see it: one the left half of the view, the other the right.
Sample in_two_views(const Sample& whole) {
  Sample both{whole.stamp_s, whole.T_odom_base, {}, whole.T_odom_recorded};
  const LaserView& view = whole.views.front();
  for (const bool left : {false, true}) {
    LaserView half{left ? 1 : 0, view.scan, view.T_base_laser};
    std::erase_if(half.scan.points, [&](const ScanPoint& point) { return (point.bearing_rad >= 0) != left; });
    std::erase_if(half.scan.free_bearings_rad, [&](double bearing_rad) { return (bearing_rad >= 0) != left; });
    both.views.push_back(std::move(half));
  }
  return both;
}

/// How far the poses of localized scans are from the truth, in standard deviations squared, on average per dimension.
double mean_normalized_error(const std::vector<ReplayedScan>& scans, const RecordedSite& site) {
  double sum = 0;
  int count = 0;
  for (const ReplayedScan& scan : scans) {
    const auto truth = site.truth.T_map_laser_at(scan.stamp_s);
    if (!truth || scan.estimate.status != Status::localized) continue;
    const Pose2 base = *truth * site.laser.T_base_laser.inverse();
    const Eigen::Vector3d off(scan.estimate.T_map_base.x() - base.x(), scan.estimate.T_map_base.y() - base.y(),
                              wrap_angle(scan.estimate.T_map_base.heading_rad() - base.heading_rad()));
    sum += off.dot(scan.estimate.covariance.inverse() * off) / 3;
    ++count;
  }
  REQUIRE(count > 10);
  return sum / count;
}

}  // namespace

TEST_CASE("two lasers that see what one sees give its answer") {
  const RecordedSite site("malaga-demo");
  LocalizerParts parts = site.parts();
  parts.lasers.push_back(parts.lasers.front());
  std::vector<Sample> halves;
  for (const Sample& sample : site.samples) halves.push_back(in_two_views(sample));
  Localizer one(site.parts()), two(parts);
  CHECK(worst_disagreement_m(replay(one, site.samples), replay(two, halves), Pose2()) < 0.1);
}

TEST_CASE("a covariance is as large as the errors are") {
  const char* name = GENERATE("malaga-demo", "malaga");
  CAPTURE(name);
  const RecordedSite site(name, RecordedSite::Extent::whole_log);
  Localizer localizer(site.parts());
  const double normalized = mean_normalized_error(replay(localizer, site.samples), site);
  CHECK(normalized > 0.1);
  CHECK(normalized < 2.5);
}
