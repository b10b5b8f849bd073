#include "deployment_text.hpp"
#include "tests/kit/shipped_plugins.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace opal;

namespace {

std::shared_ptr<const SemanticMap> wall() {
  return SemanticMap::make(
      "wall", {{"south", "opal:Wall", {MapFeatureNumber(0)}}},
      {{"south/face", MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", Segment{{0, 0}, {20, 0}}, 0, 1, {}}});
}

/// A wall 2 m to the left, measured without an error.
Scan beside_a_wall() {
  Scan scan;
  for (int beam = 0; beam < 90; ++beam) {
    const double bearing_rad = std::numbers::pi / 4 + beam * std::numbers::pi / 180,
                 range_m = 2 / std::sin(bearing_rad);
    scan.points.push_back({range_m * unit_vector(bearing_rad), range_m, bearing_rad, beam});
  }
  return scan;
}

/// Of the wall's offset, as the detector that a deployment runs finds it.
double sigma_of_wall_m(const std::string& members) {
  const LocalizerParts parts = build_parts(parsed(members), shipped_plugins(), wall());
  const std::vector<Feature> found = parts.detectors.front().part->detect(beside_a_wall());
  REQUIRE(found.size() == 1);
  return std::sqrt(found.front().covariance(0, 0));
}

const std::string kDetector = R"("detectors": [{"@type": "opal:LineDetector", "options": {"range_sigma_m": 0.1}}])";

}  // namespace

TEST_CASE("detectors take ranges to be as exact as the laser is described") {
  const double exact_m = sigma_of_wall_m(R"("sensor": {"range_sigma_m": 0.001})"),
               usual_m = sigma_of_wall_m(R"("sensor": {})"),
               rough_m = sigma_of_wall_m(R"("sensor": {"range_sigma_m": 0.1})");
  CHECK(exact_m < usual_m);
  CHECK(usual_m < rough_m);
}

TEST_CASE("what a deployment tells a detector itself holds, whatever the laser is described with") {
  CHECK(sigma_of_wall_m(R"("sensor": {"range_sigma_m": 0.001}, )" + kDetector) == sigma_of_wall_m(kDetector));
}

TEST_CASE("of several lasers the one with the most noise counts") {
  const auto lasers = [](double first_m, double second_m) {
    return R"("sensor": [{"frame": "front", "range_sigma_m": )" + std::to_string(first_m) +
           R"(}, {"frame": "rear", "range_sigma_m": )" + std::to_string(second_m) + "}]";
  };
  CHECK(sigma_of_wall_m(lasers(0.001, 0.1)) == sigma_of_wall_m(lasers(0.1, 0.1)));
}
