#include "sensing/lines/split_and_merge.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>
#include <optional>

namespace opal {
namespace {

class Extraction {
 public:
  Extraction(const ScanChains& chains, const LineExtractionOptions& options) : chains_(chains), options_(options) {}

  std::vector<Line> lines() {
    std::vector<Line> lines;
    for (const Run& piece : split_and_merged(chains_, options_)) add_line(lines, piece);
    std::sort(lines.begin(), lines.end(), [&](const Line& a, const Line& b) {
      return sightline(a.runs.front().first) < sightline(b.runs.front().first);
    });
    join_hidden(lines);
    for (Line& line : lines) set_true_ends(line);
    meet_at_junctions(lines);
    std::erase_if(lines, [&](const Line& line) {
      return line.points() < options_.min_points || line.support_m < options_.min_length_m || is_bent(line);
    });
    return lines;
  }

 private:
  const Point& position(int hit) const { return chains_.hits[hit].position; }
  int sightline(int hit) const { return chains_.sightline_of[hit]; }
  double tolerance_m(double range_m) const { return line_tolerance_m(options_, range_m); }

  void add_line(std::vector<Line>& lines, const Run& piece) const;
  void refit(Line& line) const;
  bool same_face(const Line& a, const Line& b) const;
  double open_width_m(const Line& line, int from_hit, int to_hit) const;
  bool joined(Line& line, const Line& next) const;
  void join_hidden(std::vector<Line>& lines) const;
  bool ends_beyond(const Line& line, int hit, int step) const;
  void set_true_ends(Line& line) const;
  bool is_bent(const Line& line) const;
  void meet_at_junctions(std::vector<Line>& lines) const;

  const ScanChains& chains_;
  const LineExtractionOptions& options_;
};

/// Range at which a beam meets the infinite line; infinity if it never does.
double range_to_line(const Segment& line, const Point& beam_direction) {
  const Point normal = line.normal();
  const double approach = normal.dot(beam_direction);
  return approach < -1e-9 ? normal.dot(line.begin) / approach : std::numeric_limits<double>::infinity();
}

void Extraction::add_line(std::vector<Line>& lines, const Run& piece) const {
  Line line;
  line.runs = {piece};
  refit(line);
  const bool seen_from_left = line.segment.normal().dot(line.segment.begin) < 0;
  if (line.segment.length_m() > 1e-6 && seen_from_left) lines.push_back(std::move(line));
}

/// Ends are the outermost points, projected on the fitted line.
void Extraction::refit(Line& line) const {
  const LineFit fit = fit_line(chains_, line.runs, options_.noise);
  const auto along = [&](int hit) { return fit.direction.dot(position(hit) - fit.centroid); };
  const double u_begin = along(line.runs.front().first);
  const double u_end = along(line.runs.back().last);
  line.segment = {fit.centroid + u_begin * fit.direction, fit.centroid + u_end * fit.direction};
  line.support_m = 0;
  for (const Run& run : line.runs) line.support_m += std::max(0.0, along(run.last) - along(run.first));
  const double u_mid = (u_begin + u_end) / 2;
  const double heading = fit.heading_variance_rad2;
  line.covariance << fit.offset_variance_m2 + u_mid * u_mid * heading, u_mid * heading,  //
      u_mid * heading, heading;
}

/// Whether `b` continues `a`, counter-clockwise: in line, not too far, and no wide hole in between.
bool Extraction::same_face(const Line& a, const Line& b) const {
  const bool a_longer = a.support_m >= b.support_m;
  const Line& longer = a_longer ? a : b;
  const Line& shorter = a_longer ? b : a;
  const Point along = longer.segment.direction();
  const double gap = along.dot(b.segment.begin - a.segment.end);
  if (gap > options_.max_hidden_gap_m || gap < -options_.max_offset_m) return false;
  const Point normal = left_of(along);
  for (const Point& end : {shorter.segment.begin, shorter.segment.end})
    if (std::abs(normal.dot(end - longer.segment.begin)) > options_.max_offset_m) return false;
  const double turn = std::abs(wrap_angle(a.segment.heading_rad() - b.segment.heading_rad()));
  const double sigma = std::sqrt(a.covariance(1, 1) + b.covariance(1, 1));
  if (turn > options_.max_angle_rad + std::min(2 * sigma, 0.2)) return false;
  return open_width_m(longer, a.runs.back().last, b.runs.front().first) <= options_.max_open_gap_m;
}

/// The widest part of a line, between two hits, that beams were seen to pass through.
double Extraction::open_width_m(const Line& line, int from_hit, int to_hit) const {
  const int n = static_cast<int>(chains_.sightlines.size());
  const Point along = line.segment.direction();
  double previous = along.dot(position(from_hit));
  double width = 0;
  double widest = 0;
  for (int i = (sightline(from_hit) + 1) % n; i != sightline(to_hit); i = (i + 1) % n) {
    const Sightline& beam = chains_.sightlines[i];
    const double expected = range_to_line(line.segment, beam.direction);
    if (!std::isfinite(expected)) continue;
    const double here = expected * along.dot(beam.direction);
    const bool passed = beam.range_m > expected + 2 * tolerance_m(expected);
    width = passed ? width + std::abs(here - previous) : 0;
    widest = std::max(widest, width);
    previous = here;
  }
  return widest;
}

bool Extraction::joined(Line& line, const Line& next) const {
  if (!same_face(line, next)) return false;
  line.runs.insert(line.runs.end(), next.runs.begin(), next.runs.end());
  refit(line);
  return true;
}

void Extraction::join_hidden(std::vector<Line>& lines) const {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size();)
      if (joined(lines[i], lines[j]))
        lines.erase(lines.begin() + static_cast<long>(j));
      else
        ++j;
  if (!chains_.full_circle) return;
  for (std::size_t j = 0; j < lines.size();) {  // across the seam
    const auto before = std::find_if(lines.begin() + static_cast<long>(j) + 1, lines.end(),
                                     [&](Line& line) { return joined(line, lines[j]); });
    if (before != lines.end())
      lines.erase(lines.begin() + static_cast<long>(j));
    else
      ++j;
  }
}

/// Whether the face really ends at a hit: the next beam would have hit its extension close by, and went
/// farther, and none of those after it is on the extension again (glass, railings).
bool Extraction::ends_beyond(const Line& line, int hit, int step) const {
  constexpr double kMaxSpacing_m = 0.3;  // a wider one leaves the end too uncertain
  constexpr int kBeams = 4;
  for (int k = 1; k <= kBeams; ++k) {
    const Sightline* beam = neighbour(chains_, hit, k * step);
    const double expected = beam ? range_to_line(line.segment, beam->direction) : 0;
    if (!beam || !std::isfinite(expected)) return k > 1;
    const double margin = 2 * tolerance_m(expected);
    const bool farther = expected < 0.95 * chains_.range_max_m && beam->range_m > expected + margin;
    const bool close = (expected * beam->direction - position(hit)).norm() <= kMaxSpacing_m;
    if (k == 1 && !(farther && close)) return false;
    if (std::abs(beam->range_m - expected) <= margin) return false;
  }
  return true;
}

void Extraction::set_true_ends(Line& line) const {
  line.true_end[0] = ends_beyond(line, line.runs.front().first, -1);
  line.true_end[1] = ends_beyond(line, line.runs.back().last, +1);
}

/// Whether a short line is really part of something round: a parabola v = c0 + c1 u + c2 u^2 over its points
/// bends with a radius below 1 m and explains them significantly better (F test on the one parameter more).
bool Extraction::is_bent(const Line& line) const {
  constexpr double kMaxRadius_m = 1.0;
  constexpr double kMinF = 12;  // 0.5 % by chance at 10 points
  if (line.segment.length_m() > kMaxRadius_m || line.points() < 6) return false;
  const Point along = line.segment.direction();
  const Point normal = left_of(along);
  const Point middle = line.segment.midpoint();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Eigen::Vector3d product = Eigen::Vector3d::Zero();
  double squares = 0;
  for (const Run& run : line.runs) {
    for (int i = run.first; i <= run.last; ++i) {
      const double u = along.dot(position(i) - middle);
      const double v = normal.dot(position(i) - middle);
      const Eigen::Vector3d powers(1, u, u * u);
      moments += powers * powers.transpose();
      product += powers * v;
      squares += v * v;
    }
  }
  const Eigen::Vector3d parabola = moments.ldlt().solve(product);
  const Eigen::Vector2d straight = moments.topLeftCorner<2, 2>().ldlt().solve(product.head<2>());
  const double rest = std::max(squares - product.dot(parabola), 1e-9);
  const double gain = squares - product.head<2>().dot(straight) - rest;
  return 2 * std::abs(parabola.z()) * kMaxRadius_m > 1 && gain * (line.points() - 3) > kMinF * rest;
}

/// Lines that meet end truly there; the small gap that beam spacing leaves at the corner is closed.
void Extraction::meet_at_junctions(std::vector<Line>& lines) const {
  constexpr double kMaxSnap_m = 0.15;
  constexpr double kMinArm_m = 0.15;  // shorter ones are mostly clutter at a wall
  for (const Junction& junction : find_junctions(chains_, lines, {})) {
    Line& before = lines[junction.before];
    Line& after = lines[junction.after];
    if (std::min(before.support_m, after.support_m) < kMinArm_m) continue;
    before.true_end[1] = after.true_end[0] = true;
    if ((before.segment.end - junction.position).norm() < kMaxSnap_m) before.segment.end = junction.position;
    if ((after.segment.begin - junction.position).norm() < kMaxSnap_m) after.segment.begin = junction.position;
  }
}

/// Whether hit `b` follows hit `a`, counter-clockwise, on one connected surface.
bool connected(const ScanChains& chains, int a, int b) {
  return chains.chain_of[a] == chains.chain_of[b] && (a < b || chains.closed);
}

std::optional<Point> intersection(const Segment& a, const Segment& b, double min_sine) {
  const Point along_a = a.direction();
  const Point along_b = b.direction();
  const double sine = cross(along_a, along_b);
  if (!(std::abs(sine) >= min_sine)) return std::nullopt;
  return Point(a.end + cross(b.begin - a.end, along_b) / sine * along_a);
}

}  // namespace

int Line::points() const {
  int count = 0;
  for (const Run& run : runs) count += run.size();
  return count;
}

std::vector<Line> extract_lines(const ScanChains& chains, const LineExtractionOptions& options) {
  return Extraction(chains, options).lines();
}

std::vector<Junction> find_junctions(const ScanChains& chains, std::span<const Line> lines,
                                     const JunctionOptions& options) {
  std::vector<Junction> junctions;
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    for (int j = 0; j < static_cast<int>(lines.size()); ++j) {
      const Point& end = lines[i].segment.end;
      const Point& begin = lines[j].segment.begin;
      if (i == j || (end - begin).norm() > options.max_end_distance_m) continue;
      if (!connected(chains, lines[i].runs.back().last, lines[j].runs.front().first)) continue;
      const auto position = intersection(lines[i].segment, lines[j].segment, options.min_sine);
      if (!position || (*position - end).norm() > options.max_extension_m ||
          (*position - begin).norm() > options.max_extension_m)
        continue;
      junctions.push_back({i, j, *position});
    }
  }
  return junctions;
}

}  // namespace opal
