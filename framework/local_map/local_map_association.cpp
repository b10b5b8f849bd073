#include "local_map/local_map_association.hpp"

#include <algorithm>
#include <tuple>

namespace opal {
namespace {

using Cost = std::optional<double>;

Cost gated(double value, double gate) { return std::abs(value) <= gate ? Cost(std::abs(value) / gate) : std::nullopt; }

Cost sum(Cost a, Cost b) { return a && b ? Cost(*a + *b) : std::nullopt; }

/// How far `piece` lies beyond the ends of `line` along it [m]; negative: they overlap by that much. An end that is
/// known to be the object's own leaves no room for a gap.
struct Gap {
  double length_m;
  bool closed;
};

Gap gap_between(const Segment& line, const std::array<bool, 2>& line_true, const Segment& piece,
                const std::array<bool, 2>& piece_true) {
  const Point along = line.direction();
  const double begin = along.dot(piece.begin - line.begin);
  const double end = along.dot(piece.end - line.begin);
  const double before = -end;                    // the piece ends this far before the line begins
  const double after = begin - line.length_m();  // the piece begins this far after the line ends
  if (before > after) return {before, line_true[0] || piece_true[1]};
  return {after, line_true[1] || piece_true[0]};
}

double farthest_end_m(const Segment& line, const Segment& piece) {
  const Point normal = line.normal();
  return std::max(std::abs(normal.dot(piece.begin - line.begin)), std::abs(normal.dot(piece.end - line.begin)));
}

/// A bound that costs no arc tangent: no angle is less than its sine. Most pairs of walls are far from parallel.
bool are_surely_turned(const Segment& a, const Segment& b, double by_rad) {
  const Point along_a = a.end - a.begin, along_b = b.end - b.begin;
  const double across = cross(along_a, along_b);
  return across * across > by_rad * by_rad * along_a.squaredNorm() * along_b.squaredNorm();
}

/// Both ends of the shorter one near the infinite line of the longer one, whose direction is better known.
Cost segment_cost(const Feature& a, const Feature& b, const LocalMapOptions& options) {
  const auto& segment_a = std::get<Segment>(a.geometry);
  const auto& segment_b = std::get<Segment>(b.geometry);
  if (are_surely_turned(segment_a, segment_b, options.association_angle_rad)) return std::nullopt;
  const bool a_longer = segment_a.length_m() >= segment_b.length_m();
  const Segment& line = a_longer ? segment_a : segment_b;
  const Segment& piece = a_longer ? segment_b : segment_a;
  const Cost heading = gated(wrap_angle(line.heading_rad() - piece.heading_rad()), options.association_angle_rad);
  if (!heading) return std::nullopt;
  const Gap gap =
      a_longer ? gap_between(line, a.true_end, piece, b.true_end) : gap_between(line, b.true_end, piece, a.true_end);
  if (gap.length_m > (gap.closed ? 0.0 : options.association_distance_m)) return std::nullopt;
  return sum(heading, gated(farthest_end_m(line, piece), options.association_offset_m));
}

struct CostOfShapes {
  const LocalMapOptions& options;
  Cost operator()(const Point& a, const Point& b) const {
    return gated((a - b).norm(), options.association_distance_m);
  }
  Cost operator()(const OrientedPoint& a, const OrientedPoint& b) const {
    const Cost direction = sum(gated(wrap_angle(a.heading_rad - b.heading_rad), options.association_angle_rad),
                               gated(a.opening_rad - b.opening_rad, options.association_angle_rad));
    return sum(direction, gated((a.position - b.position).norm(), options.association_distance_m));
  }
  Cost operator()(const Circle& a, const Circle& b) const {
    return sum(gated((a.center - b.center).norm(), options.association_distance_m),
               gated(a.radius_m - b.radius_m, options.association_radius_m));
  }
  template <class A, class B>
  Cost operator()(const A&, const B&) const {
    return std::nullopt;
  }
};

struct Pair {
  double cost;
  std::size_t detection;
  std::size_t local;
};

std::vector<Pair> possible_pairs(const std::vector<Feature>& detections, const std::vector<LocalFeature>& local,
                                 const LocalMapOptions& options) {
  std::vector<Pair> pairs;
  for (std::size_t d = 0; d < detections.size(); ++d)
    for (std::size_t l = 0; l < local.size(); ++l)
      if (const Cost cost = association_cost(detections[d], local[l].feature, options)) pairs.push_back({*cost, d, l});
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.cost, a.detection, a.local) < std::tie(b.cost, b.detection, b.local);
  });
  return pairs;
}

}  // namespace

std::optional<double> association_cost(const Feature& a, const Feature& b, const LocalMapOptions& options) {
  if (a.type != b.type || kind_of(a.geometry) != kind_of(b.geometry)) return std::nullopt;
  if (kind_of(a.geometry) == GeometryKind::segment) return segment_cost(a, b, options);
  return std::visit(CostOfShapes{options}, a.geometry, b.geometry);
}

std::vector<int> associate(const std::vector<Feature>& detections, const std::vector<LocalFeature>& local,
                           const LocalMapOptions& options) {
  std::vector<int> partner(detections.size(), -1);
  std::vector<bool> taken(local.size(), false);
  for (const Pair& pair : possible_pairs(detections, local, options)) {
    if (partner[pair.detection] >= 0 || taken[pair.local]) continue;
    partner[pair.detection] = static_cast<int>(pair.local);
    taken[pair.local] = kind_of(detections[pair.detection].geometry) != GeometryKind::segment;
  }
  return partner;
}

}  // namespace opal
