#include <opal/plugin/testing/detector_contract.hpp>

#include "plugin/testing/scene.hpp"
#include "plugin/testing/violations.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <future>
#include <limits>

namespace opal::testing {
namespace {

constexpr const char* kTurnCause =
    "the result depends on where the sweep begins, or this feature stands at a threshold of the options";

using Features = std::vector<Feature>;

struct NamedScan {
  std::string name;
  Scan scan;
};

Scan scan_of(const std::vector<Point>& positions) {
  Scan scan;
  scan.angle_increment_rad = 0.01;
  scan.range_max_m = 30;
  for (const Point& p : positions)
    scan.points.push_back({p, p.norm(), std::atan2(p.y(), p.x()), static_cast<int>(scan.points.size())});
  return scan;
}

Scan huge_scan() {
  std::vector<Point> positions;
  for (int i = 0; i < 50000; ++i) {
    const double bearing = -3.1 + 6.2 * i / 50000.0;
    positions.push_back((5 + 2 * std::sin(7 * bearing)) * unit_vector(bearing));
  }
  return scan_of(positions);
}

std::vector<NamedScan> poor_scans(const Scan& example) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Scan holes = example;
  for (std::size_t i = 0; i < holes.points.size(); i += 5)
    holes.points[i] = {{nan, nan}, nan, holes.points[i].bearing_rad, holes.points[i].beam};
  Scan far = example;
  for (ScanPoint& point : far.points)
    point = {1e9 * point.position, 1e9 * point.range_m, point.bearing_rad, point.beam};
  return {{"an empty scan", Scan{}},
          {"a scan of one point", scan_of({{2, 1}})},
          {"a scan of two points", scan_of({{2, 1}, {2, 1.1}})},
          {"a scan of 400 equal points", scan_of(std::vector<Point>(400, Point(2, 1)))},
          {"a scan of points where the sensor stands", scan_of(std::vector<Point>(50, Point(0, 0)))},
          {"a scan of points on one ray", scan_of({{1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {7, 0}, {8, 0}})},
          {"a scan of not-a-number points", scan_of(std::vector<Point>(50, Point(nan, nan)))},
          {"a scan of infinite points", scan_of(std::vector<Point>(50, Point(infinity, -infinity)))},
          {"a scan in which every fifth point is not a number", holes},
          {"a scan of points a million kilometres away", far},
          {"a scan of 50000 points", huge_scan()}};
}

/// How many rows of the covariance a geometry uses.
int dimensions_of(const Geometry& geometry) {
  const GeometryKind kind = kind_of(geometry);
  return kind == GeometryKind::point || kind == GeometryKind::segment ? 2 : 3;
}

std::string covariance_defect(const Feature& feature) {
  const Eigen::Matrix3d& covariance = feature.covariance;
  const int n = dimensions_of(feature.geometry);
  if (!covariance.allFinite()) return "has a covariance that is not finite";
  const Eigen::MatrixXd used = covariance.topLeftCorner(n, n);
  const double scale = used.cwiseAbs().maxCoeff();
  if (!used.isApprox(used.transpose(), 1e-9)) return "has a covariance that is not symmetric";
  if (used.diagonal().minCoeff() <= 0) return "has a covariance without a positive variance for each of its numbers";
  if (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(used).eigenvalues().minCoeff() < -1e-9 * scale)
    return "has a covariance with a negative eigenvalue";
  if (n == 2 && (!covariance.row(2).isZero(0) || !covariance.col(2).isZero(0)))
    return "has a covariance with numbers in its unused third row or column";
  return {};
}

class Detection {
 public:
  Detection(const FeatureDetector& detector, const TypeInfo& type, const DetectorTrial& trial)
      : detector_(detector), type_(type), trial_(trial), violations_(type.name) {}

  std::vector<std::string> run() {
    const Scan example = trial_.scans.empty() ? example_scans().front() : trial_.scans.front();
    for (const auto& [name, scan] : poor_scans(example)) check_features(name, detect(name, scan));
    std::size_t found = 0;
    for (std::size_t i = 0; i < trial_.scans.size(); ++i) {
      const std::string name = "example scan " + std::to_string(i);
      found += check_scan(name, trial_.scans[i]);
    }
    if (trial_.must_find_something && found == 0)
      violations_.add("blind", "finds nothing in any of the " + std::to_string(trial_.scans.size()) + " scans");
    return violations_.take();
  }

 private:
  Features detect(const std::string& name, const Scan& scan) {
    Features features;
    violations_.expect_no_throw(name, [&] { features = detector_.detect(scan); });
    return features;
  }

  /// @return how much was found
  std::size_t check_scan(const std::string& name, const Scan& scan) {
    const Features features = detect(name, scan);
    check_features(name, features);
    if (!same(features, detect(name, scan)))
      violations_.add("repeat", "finds different features when it sees " + name + " again",
                      "a member that detect() changes, a random number, or a value that was never set");
    check_threads(name, scan, features);
    for (const double turn_rad : {-0.7, -0.1, 0.013, 0.4}) check_turned(name, scan, features, turn_rad);
    return features.size();
  }

  void check_features(const std::string& name, const Features& features) {
    for (const Feature& feature : features) {
      const std::string subject = "finds " + described(feature.geometry) + " in " + name + ", which ";
      if (std::find(type_.produces.begin(), type_.produces.end(), feature.type) == type_.produces.end())
        violations_.add("type",
                        subject + "is of type \"" + feature.type + "\", but it does not say that it produces these");
      if (!is_possible(feature.geometry)) violations_.add("geometry", subject + "is no possible shape");
      const std::string defect = covariance_defect(feature);
      if (!defect.empty()) violations_.add("covariance", subject + defect);
      if (!(feature.support_m >= 0) || !std::isfinite(feature.support_m))
        violations_.add("support", subject + "has a support of " + std::to_string(feature.support_m) + " m");
    }
  }

  void check_threads(const std::string& name, const Scan& scan, const Features& expected) {
    const auto ask = [&] {
      bool agrees = true;
      for (int i = 0; i < 3; ++i) agrees = agrees && same(detector_.detect(scan), expected);
      return agrees;
    };
    violations_.expect_no_throw(name + ", asked from two threads", [&] {
      auto other = std::async(std::launch::async, ask);
      const bool here = ask();
      if (!other.get() || !here)
        violations_.add("threads", "finds different features in " + name + " when two threads ask at once",
                        "a static or mutable variable that both threads write");
    });
  }

  void check_turned(const std::string& name, const Scan& scan, const Features& features, double turn_rad) {
    const std::string occasion = name + ", turned by " + std::to_string(turn_rad) + " rad";
    const Features found = detect(occasion, turned(scan, turn_rad));
    if (found.size() != features.size()) {
      violations_.add("turn",
                      "finds " + std::to_string(features.size()) + " features in " + name + ", but " +
                          std::to_string(found.size()) + " in " + occasion,
                      kTurnCause);
      return;
    }
    for (const Feature& feature : features) {
      const Feature expected = transformed(Pose2(0, 0, turn_rad), feature);
      const auto is_this = [&](const Feature& candidate) { return alike(expected, candidate); };
      if (std::none_of(found.begin(), found.end(), is_this))
        violations_.add("turn",
                        "finds " + described(feature.geometry) + " in " + name + ", but not its like in " + occasion +
                            fmt::format(" (within {:g} m, {:g} rad and 1 % of the covariance)",
                                        trial_.position_tolerance_m, trial_.angle_tolerance_rad),
                        kTurnCause);
    }
  }

  static bool same(const Features& a, const Features& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Feature& f, const Feature& g) {
      return f.type == g.type && alike(f.geometry, g.geometry, 0, 0) && f.covariance == g.covariance &&
             f.true_end == g.true_end && f.support_m == g.support_m;
    });
  }

  bool alike(const Feature& a, const Feature& b) const {
    const double scale = a.covariance.cwiseAbs().maxCoeff();
    return a.type == b.type && a.true_end == b.true_end &&
           alike(a.geometry, b.geometry, trial_.position_tolerance_m, trial_.angle_tolerance_rad) &&
           (a.covariance - b.covariance).cwiseAbs().maxCoeff() <= 1e-2 * scale;
  }

  static bool alike(const Geometry& a, const Geometry& b, double position_m, double angle_rad) {
    if (a.index() != b.index()) return false;
    const auto near = [&](const Point& p, const Point& q) { return (p - q).norm() <= position_m; };
    if (const auto* p = std::get_if<Point>(&a)) return near(*p, std::get<Point>(b));
    if (const auto* s = std::get_if<Segment>(&a))
      return near(s->begin, std::get<Segment>(b).begin) && near(s->end, std::get<Segment>(b).end);
    if (const auto* c = std::get_if<Circle>(&a))
      return near(c->center, std::get<Circle>(b).center) &&
             std::abs(c->radius_m - std::get<Circle>(b).radius_m) <= position_m;
    const auto &o = std::get<OrientedPoint>(a), &q = std::get<OrientedPoint>(b);
    return near(o.position, q.position) && std::abs(wrap_angle(o.heading_rad - q.heading_rad)) <= angle_rad &&
           std::abs(o.opening_rad - q.opening_rad) <= angle_rad;
  }

  const FeatureDetector& detector_;
  const TypeInfo& type_;
  const DetectorTrial& trial_;
  Violations violations_;
};

/// A hall too wide for the laser, with columns and one far wall.
std::vector<Geometry> example_hall() {
  std::vector<Geometry> surfaces{Segment{{10, -9}, {10.5, 9}}, Segment{{-2, 6}, {-9, 6.5}}};
  for (int i = 0; i < 4; ++i) surfaces.push_back(Circle{{-4.0 + 3.1 * i, -2.7 + 0.2 * i}, 0.3});
  return surfaces;
}

}  // namespace

std::vector<Scan> example_scans() {
  std::vector<Scan> scans;
  const std::vector<Pose2> places{{3.5, 2.3, 0.2}, {6.1, 4.2, -2.5}, {1.0, 2.6, 1.1}, {3.8, 1.0, -1.6}};
  for (const Pose2& place : places)
    scans.push_back(simulated_scan(example_room(), place, static_cast<unsigned>(scans.size())));
  scans.push_back(simulated_scan(example_hall(), {0, 0, 0.4}, 9));
  return scans;
}

std::vector<std::string> detector_violations(const FeatureDetector& detector, const TypeInfo& type,
                                             const DetectorTrial& trial) {
  return Detection(detector, type, trial).run();
}

}  // namespace opal::testing
