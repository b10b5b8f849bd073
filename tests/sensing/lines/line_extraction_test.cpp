#include <opal/sensing/lines/line_corner.hpp>
#include <opal/sensing/lines/line_extraction.hpp>

#include <catch2/catch.hpp>

namespace {

using namespace opal;

/// Hits at given ranges, 1 degree apart, from bearing 0 on; a range of 0 leaves the beam out, a negative one
/// is free.
Scan scan_with(const std::vector<double>& ranges_m) {
  Scan scan;
  scan.angle_increment_rad = std::numbers::pi / 180;
  scan.range_max_m = 30;
  for (int i = 0; i < static_cast<int>(ranges_m.size()); ++i) {
    const double range = ranges_m[static_cast<std::size_t>(i)];
    const double bearing = i * scan.angle_increment_rad;
    if (range < 0) scan.free_bearings_rad.push_back(bearing);
    if (range > 0) scan.points.push_back({range * unit_vector(bearing), range, bearing, i});
  }
  return scan;
}

std::vector<int> chain_sizes(const Scan& scan) {
  std::vector<int> sizes;
  for (const Run& chain : chained(scan, {}).chains) sizes.push_back(chain.size());
  return sizes;
}

ScanChains chains_of(const std::vector<Point>& points) {
  ScanChains chains;
  for (const Point& p : points) chains.hits.push_back({p, p.norm(), std::atan2(p.y(), p.x()), 0});
  return chains;
}

/// What a laser at the origin sees of faces, a quarter of a degree apart, from -60 to 60 degrees.
Scan scan_of(const std::vector<Segment>& faces) {
  Scan scan;
  scan.angle_increment_rad = std::numbers::pi / 720;
  scan.range_max_m = 30;
  for (int beam = -240; beam <= 240; ++beam) {
    const double bearing = beam * scan.angle_increment_rad;
    const Point along = unit_vector(bearing);
    double nearest_m = scan.range_max_m;
    for (const Segment& face : faces) {
      const double across = cross(along, face.end - face.begin);
      const double range_m = cross(face.begin, face.end - face.begin) / across, at = cross(face.begin, along) / across;
      if (range_m > 0 && at >= 0 && at <= 1) nearest_m = std::min(nearest_m, range_m);
    }
    if (nearest_m < scan.range_max_m)
      scan.points.push_back({nearest_m * along, nearest_m, bearing, beam + 240});
    else
      scan.free_bearings_rad.push_back(bearing);
  }
  return scan;
}

/// Lines about 2 m ahead: two pieces of a wall, or one, if something nearer hides what lies between them.
int pieces_of_wall(double turned_rad) {
  const Point begin(2, 0.7), end = begin + 0.45 * unit_vector(std::numbers::pi / 2 + turned_rad);
  const auto lines = extract_lines(chained(scan_of({{{2, -1}, {2, 0.3}}, {{1, 0.1}, {1, 0.4}}, {begin, end}}), {}), {});
  return static_cast<int>(
      std::count_if(lines.begin(), lines.end(), [](const Line& line) { return line.segment.midpoint().x() > 1.5; }));
}

/// Lines about 4 m ahead: two metres of wall to each side of what a box nearer by hides.
std::size_t pieces_beside_hidden(double hidden_m) {
  const double half_m = hidden_m / 2;
  const std::vector<Segment> faces{
      {{4, -half_m - 2}, {4, -half_m}}, {{1, -half_m / 4}, {1, half_m / 4}}, {{4, half_m}, {4, half_m + 2}}};
  const auto lines = extract_lines(chained(scan_of(faces), {}), {});
  return static_cast<std::size_t>(
      std::count_if(lines.begin(), lines.end(), [](const Line& line) { return line.segment.midpoint().x() > 3; }));
}

LineFit fit(const std::vector<Point>& points, const ReadingNoise& noise) {
  const Run run{0, static_cast<int>(points.size()) - 1};
  return fit_line(chains_of(points), {&run, 1}, noise);
}

}  // namespace

TEST_CASE("a jump in range and a run of missing beams are breaks, a few missing beams are not") {
  CHECK(chain_sizes(scan_with({2, 2, 2, 4, 4})) == std::vector{3, 2});
  CHECK(chain_sizes(scan_with({2, 2, 0, 0, 0, 2, 2})) == std::vector{4});
  CHECK(chain_sizes(scan_with({2, 2, 0, 0, 0, 0, 2, 2})) == std::vector{2, 2});
}

TEST_CASE("a railing and the wall behind it are two chains") {
  CHECK(chain_sizes(scan_with({2, 4, 2, 4, 4, 2, 4, 2, 4})) == std::vector{4, 5});
}

TEST_CASE("neighbouring beams are found through free ones, and not beyond the view") {
  const ScanChains chains = chained(scan_with({2, 2, -1, 5}), {});
  REQUIRE(neighbour(chains, 1, 1));
  CHECK(std::isinf(neighbour(chains, 1, 1)->range_m));
  REQUIRE(neighbour(chains, 1, 2));
  CHECK(neighbour(chains, 1, 2)->range_m == 5);
  CHECK(neighbour(chains, 0, -1) == nullptr);
  CHECK(neighbour(chains, 2, 1) == nullptr);
}

TEST_CASE("a hit of which position, bearing or range are no number is in no chain") {
  for (int broken = 0; broken < 5; ++broken) {
    Scan scan = scan_with({2, 2, 2, 2});
    ScanPoint& hit = scan.points[1];
    if (broken == 0) hit.position.x() = NAN;
    if (broken == 1) hit.position.y() = INFINITY;
    if (broken == 2) hit.bearing_rad = NAN;
    if (broken == 3) hit.range_m = INFINITY;
    if (broken == 4) hit.range_m = 0;
    CAPTURE(broken);
    CHECK(chain_sizes(scan) == std::vector{3});
  }
}

TEST_CASE("across a face seen head-on the range's noise counts, along a beam that grazes it the bearing's") {
  const ReadingNoise noise{.range_sigma_m = 0.03, .bearing_sigma_rad = 0.002, .surface_sigma_m = 0.01};
  const ScanPoint hit{{5, 0}, 5, 0, 0};
  const auto variance = [&](double off_rad) { return variance_across(hit, unit_vector(off_rad), noise); };
  CHECK(variance(0) == Approx(0.0009 + 0.0001));
  CHECK(variance(std::numbers::pi / 2) == Approx(0.01 * 0.01 + 0.0001));
  CHECK(variance(std::numbers::pi / 3) == Approx(0.0009 / 4 + 0.0001 * 3 / 4 + 0.0001));
}

TEST_CASE("a line through exact points is exact, whatever its heading") {
  const double heading = GENERATE(0.0, 0.8, std::numbers::pi / 2, 2.5, -3.0);
  const Point from(3, 1);
  std::vector<Point> points;
  for (int i = 0; i < 10; ++i) points.push_back(from + 0.1 * i * unit_vector(heading));
  const LineFit line = fit(points, {});
  CAPTURE(heading);
  CHECK(line.direction.isApprox(unit_vector(heading), 1e-9));
  CHECK(std::abs(cross(line.direction, line.centroid - from)) < 1e-9);
  CHECK(line.rms_m < 1e-9);
}

TEST_CASE("the variances of equally good points are the textbook ones") {
  // Seen head-on from afar all weights are 1 / sigma^2: variance sigma^2 / n, and sigma^2 / sum of squared
  // lever arms.
  std::vector<Point> points;
  double levers = 0;
  for (int i = -5; i <= 5; ++i) {
    points.push_back({1000, 0.1 * i});
    levers += 0.01 * i * i;
  }
  const LineFit line = fit(points, {.range_sigma_m = 0.02, .bearing_sigma_rad = 0, .surface_sigma_m = 0});
  CHECK(line.offset_variance_m2 == Approx(0.0004 / 11).epsilon(1e-3));
  CHECK(line.heading_variance_rad2 == Approx(0.0004 / levers).epsilon(1e-3));
}

TEST_CASE("an outlier among many points hardly moves the line") {
  std::vector<Point> points;
  for (int i = 0; i < 30; ++i) points.push_back({2, 0.05 * i});
  points[29].x() = 1.5;
  const LineFit line = fit(points, {});
  CHECK(std::abs(line.centroid.x() - 2) < 0.005);
  CHECK(std::abs(line.direction.x()) < 0.01);
}

TEST_CASE("the covariance of a corner follows its lines' offsets") {
  Line before;
  Line after;
  before.segment = {{3, -2}, {3, 1}};
  after.segment = {{3, 1}, {0, 1}};
  before.covariance = Eigen::Vector2d(0.0004, 0).asDiagonal();
  after.covariance = Eigen::Vector2d(0.0001, 0).asDiagonal();
  const std::vector<Line> lines{before, after};
  const LineCorner corner = corner_at({0, 1, {3, 1}}, lines);
  CHECK(corner.geometry.opening_rad == Approx(std::numbers::pi / 2));
  CHECK(corner.covariance(0, 0) == Approx(0.0004));
  CHECK(corner.covariance(1, 1) == Approx(0.0001));
  CHECK(corner.covariance(2, 2) == Approx(0).margin(1e-12));
}

TEST_CASE("two pieces of a wall are one behind something nearer, if they are as parallel as their headings are known") {
  CHECK(pieces_of_wall(0) == 1);
  CHECK(pieces_of_wall(0.04) == 1);
  CHECK(pieces_of_wall(0.17) == 2);
  CHECK(pieces_of_wall(-0.17) == 2);
}

TEST_CASE("a wall goes on behind what hides it, but not behind what hides more of it than a wall is trusted to span") {
  const double most_m = LineExtractionOptions{}.max_hidden_gap_m;
  CHECK(pieces_beside_hidden(0.5) == 1);
  CHECK(pieces_beside_hidden(0.9 * most_m) == 1);
  CHECK(pieces_beside_hidden(1.1 * most_m) == 2);
}

TEST_CASE("chains begin after the largest break, and missing beams are a larger one than a jump in range") {
  std::vector<double> ranges(360, 2);  // all around
  std::fill(ranges.begin() + 100, ranges.begin() + 140, 0);
  for (std::size_t beam = 250; beam < 300; ++beam) ranges[beam] = 2.4;
  const ScanChains chains = chained(scan_with(ranges), {});
  REQUIRE_FALSE(chains.hits.empty());
  CHECK(chains.hits.front().beam == 140);
}

TEST_CASE("the covariance of a line is that of its offset at the middle between its ends") {
  const ScanChains chains = chained(scan_of({{{2, -0.5}, {2, 3}}}), {});  // most hits lie near its begin
  const auto lines = extract_lines(chains, {});
  REQUIRE(lines.size() == 1);
  const LineFit fitted = fit_line(chains, lines.front().runs, LineExtractionOptions{}.noise);
  const double off_m = fitted.direction.dot(lines.front().segment.midpoint() - fitted.centroid);
  REQUIRE(std::abs(off_m) > 0.05);
  const Eigen::Matrix2d covariance = lines.front().covariance;
  CHECK(covariance(0, 0) == Approx(fitted.offset_variance_m2 + off_m * off_m * fitted.heading_variance_rad2));
  CHECK(covariance(0, 1) == Approx(off_m * fitted.heading_variance_rad2));
}

TEST_CASE("a point that is three standard deviations off counts half, a point on the line in full") {
  std::vector<Point> points;
  for (int i = -20; i <= 20; ++i) points.push_back({1000, 0.1 * i});
  for (const double off_m : {0.06, -0.06})
    for (const double at_m : {-1.0, 1.0}) points.insert(points.begin() + 20, {1000 + off_m, at_m});
  const LineFit line = fit(points, {.range_sigma_m = 0.02, .bearing_sigma_rad = 0, .surface_sigma_m = 0});
  CHECK(line.offset_variance_m2 == Approx(0.0004 / (41 + 4 * 0.5)).epsilon(1e-3));
}
