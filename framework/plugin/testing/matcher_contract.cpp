#include <opal/plugin/testing/matcher_contract.hpp>

#include "plugin/testing/scene.hpp"
#include "plugin/testing/violations.hpp"

#include <future>
#include <limits>

namespace opal::testing {
namespace {

using Points = std::vector<Point>;

const Eigen::Vector3d kGuessSigma(0.05, 0.05, 0.03);

Points positions(const Scan& scan) {
  Points points;
  for (const ScanPoint& point : scan.points) points.push_back(point.position);
  return points;
}

bool same(const ScanMatch& a, const ScanMatch& b) {
  return a.converged == b.converged && a.T_reference_scan.position() == b.T_reference_scan.position() &&
         a.T_reference_scan.heading_rad() == b.T_reference_scan.heading_rad() && a.inlier_share == b.inlier_share;
}

class Laying {
 public:
  Laying(const ScanMatcher& matcher, const TypeInfo& type) : matcher_(matcher), violations_(type.name) {}

  std::vector<std::string> run() {
    const Points room = positions(simulated_scan(example_room(), {3.5, 2.3, 0.2}, 1));
    check_poor(room);
    int converged = 0;
    for (const Pose2& step : {Pose2(0, 0, 0), Pose2(0.1, 0, 0), Pose2(0.05, 0.02, 0.1), Pose2(0.15, -0.05, -0.2)})
      converged += check_step(room, step);
    if (converged == 0) violations_.add("never", "never converges on scans of a room from a guess that is 5 cm off");
    return violations_.take();
  }

 private:
  ScanMatch match(const std::string& name, const Points& reference, const Points& scan, const Pose2& guess) {
    ScanMatch result;
    violations_.expect_no_throw(name, [&] { result = matcher_.match(reference, scan, guess, kGuessSigma); });
    check_result(name, result);
    return result;
  }

  void check_result(const std::string& name, const ScanMatch& result) {
    if (!result.converged) return;
    if (!is_finite(result.T_reference_scan) || !result.covariance.allFinite())
      violations_.add("finite", "converges on " + name + " with numbers that are not finite");
    if (!(result.inlier_share >= 0 && result.inlier_share <= 1))
      violations_.add("share", "reports an inlier share of " + std::to_string(result.inlier_share) + " on " + name);
  }

  void check_poor(const Points& room) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Points none, one{{2, 1}}, equal(100, Point(2, 1)), broken(100, Point(nan, nan));
    const auto expect_no_match = [&](const std::string& name, const Points& reference, const Points& scan) {
      if (match(name, reference, scan, Pose2()).converged)
        violations_.add("poor", "says that it has converged on " + name);
    };
    expect_no_match("two empty scans", none, none);
    expect_no_match("an empty reference", none, room);
    expect_no_match("an empty scan", room, none);
    expect_no_match("a scan of one point", room, one);
    expect_no_match("a reference of one point", one, room);
    expect_no_match("a scan of not-a-number points", room, broken);
    expect_no_match("a reference of not-a-number points", broken, room);
    match("a scan of equal points", room, equal, Pose2());
    match("a guess far away", room, room, Pose2(1e5, 0, 0));
  }

  /// @return whether it converged
  bool check_step(const Points& room, const Pose2& T_reference_scan) {
    const Points scan = positions(simulated_scan(example_room(), Pose2(3.5, 2.3, 0.2) * T_reference_scan, 2));
    const Pose2 guess = T_reference_scan * Pose2(0.04, -0.03, 0.03);
    const ScanMatch result = match("a scan of a room", room, scan, guess);
    check_threads(room, scan, guess, result);
    if (!result.converged) return false;
    const double error_m = distance_m(result.T_reference_scan, T_reference_scan);
    const double error_rad = angle_between_rad(result.T_reference_scan, T_reference_scan);
    if (error_m > 0.03 || error_rad > 0.015)  // the guess is 0.05 m and 0.03 rad off
      violations_.add(
          "error",
          "says that it has converged on a scan of a room, but is " + std::to_string(error_m) + " m and " +
              std::to_string(error_rad) + " rad off, expected at most 0.03 m and 0.015 rad",
          "the guess is returned as it is, or the pose of the reference in the scan instead of the reverse");
    return true;
  }

  void check_threads(const Points& room, const Points& scan, const Pose2& guess, const ScanMatch& expected) {
    violations_.expect_no_throw("a scan of a room, asked from two threads", [&] {
      const auto agrees = [&] { return same(matcher_.match(room, scan, guess, kGuessSigma), expected); };
      auto other = std::async(std::launch::async, agrees);
      const bool here = agrees();
      if (!other.get() || !here)
        violations_.add("repeat", "gives another answer when it is asked again, or from another thread",
                        "a static or mutable variable, or a random number without a fixed seed");
    });
  }

  const ScanMatcher& matcher_;
  Violations violations_;
};

}  // namespace

std::vector<std::string> matcher_violations(const ScanMatcher& matcher, const TypeInfo& type) {
  return Laying(matcher, type).run();
}

}  // namespace opal::testing
