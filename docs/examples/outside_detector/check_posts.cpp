// check_posts PLUGIN: loads the plugin as a robot would, puts it through the contract with scans that hold a
// post, and looks whether the post is found where it stands.
#include <opal/plugin/plugin_registry.hpp>
#include <opal/plugin/testing/detector_contract.hpp>
#include <opal/plugin/testing/plugin_contract.hpp>

#include <iostream>

namespace {

/// A post 2 m ahead, 5 cm wide, in front of a wall 4 m ahead.
opal::Scan scan_with_post() {
  opal::Scan scan;
  scan.angle_increment_rad = 0.005;
  scan.range_max_m = 10;
  for (int beam = -150; beam <= 150; ++beam) {
    const double bearing_rad = 0.005 * beam;
    const double range_m = std::abs(2 * bearing_rad) < 0.025 ? 2 : 4 / std::cos(bearing_rad);
    scan.points.push_back({range_m * opal::unit_vector(bearing_rad), range_m, bearing_rad, beam + 150});
  }
  return scan;
}

int count_problems(const std::string& file) {
  opal::PluginRegistry registry;
  registry.load(file);
  const auto detector = registry.make<opal::FeatureDetector>("acme:PostDetector", {{"max_width_m", 0.1}});

  opal::testing::DetectorTrial trial;
  trial.scans = {scan_with_post()};
  trial.must_find_something = true;
  std::vector<std::string> problems =
      opal::testing::detector_violations(*detector, registry.type("acme:PostDetector").info, trial);
  for (std::string& problem : opal::testing::plugin_violations(file)) problems.push_back(std::move(problem));

  const std::vector<opal::Feature> posts = detector->detect(scan_with_post());
  if (posts.size() != 1 || (opal::anchor_of(posts.front().geometry) - opal::Point(2, 0)).norm() > 0.02)
    problems.push_back("the post at (2, 0) is not found, or not alone");
  for (const std::string& problem : problems) std::cerr << problem << "\n";
  return static_cast<int>(problems.size());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: check_posts PLUGIN\n";
    return 2;
  }
  return count_problems(argv[1]) == 0 ? 0 : 1;
} catch (const opal::Error& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
