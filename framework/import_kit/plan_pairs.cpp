#include "import_kit/plan_pairs.hpp"

#include "import_kit/plan_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace opal {
namespace {

// Chords of concentric arcs differ by this much, and the chords of one arc bend by less than that.
constexpr double kMaxParallelSine = 0.2;
constexpr double kMinGoingOnCosine = 0.93;
// A square pillar's sides are just as long as they are apart.
constexpr double kMinOverlapByDistance = 0.95;
// Cavities and insulation in walls are narrower than this, niches are not.
constexpr double kMinNiche_m = 0.3;
// So much thinner are the walls on both sides of a niche, and along so much of it they run.
constexpr double kMaxWallByNiche = 0.75;
constexpr double kMinWallAlongNiche = 0.5;

/// Two edges side by side: the stretch of the first one [m from its begin], and the wall between them.
struct SideBySide {
  int edge = 0, other = 0;
  double from_m = 0, to_m = 0;
  double distance_m = 0;
  bool is_left = false;
  std::array<Point, 4> between;
};

/// Edges that go on into each other have one number.
class Runs {
 public:
  Runs(const PlanStrokes& strokes, const std::vector<bool>& takes_part)
      : strokes_(strokes), run_(strokes.edges.size()) {
    std::iota(run_.begin(), run_.end(), 0);
    std::vector<std::vector<int>> at_node(strokes.nodes.size());
    for (std::size_t k = 0; k < strokes.edges.size(); ++k) {
      if (!takes_part[k]) continue;
      at_node[static_cast<std::size_t>(strokes.edges[k].from)].push_back(static_cast<int>(k));
      at_node[static_cast<std::size_t>(strokes.edges[k].to)].push_back(static_cast<int>(k));
    }
    for (std::size_t node = 0; node < at_node.size(); ++node) join_at(static_cast<int>(node), at_node[node]);
  }

  int of(int edge) {
    int& next = run_[static_cast<std::size_t>(edge)];
    return next == edge ? edge : next = of(next);
  }

 private:
  Point away_from(int node, int number) const {
    const PlanEdge& edge = strokes_.edges[static_cast<std::size_t>(number)];
    return (strokes_.at(edge.from == node ? edge.to : edge.from) - strokes_.at(node)).normalized();
  }

  void join_at(int node, const std::vector<int>& edges) {
    for (const int a : edges) {
      int best = -1;
      double best_cosine = kMinGoingOnCosine;
      for (const int b : edges)
        if (const double cosine = -away_from(node, a).dot(away_from(node, b)); b != a && cosine > best_cosine) {
          best = b;
          best_cosine = cosine;
        }
      if (best >= 0) run_[static_cast<std::size_t>(of(a))] = of(best);
    }
  }

  const PlanStrokes& strokes_;
  std::vector<int> run_;
};

std::optional<SideBySide> side_by_side(const Segment& a, const Segment& b, const PlanOptions& options) {
  const Point along = a.direction();
  if (std::abs(cross(along, b.direction())) > kMaxParallelSine) return std::nullopt;
  const double p = along.dot(b.begin - a.begin), q = along.dot(b.end - a.begin);
  SideBySide found;
  found.from_m = std::max(0.0, std::min(p, q));
  found.to_m = std::min(a.length_m(), std::max(p, q));
  if (found.to_m - found.from_m <= options.join_m) return std::nullopt;
  const auto on_b = [&](double at) -> Point { return b.begin + (at - p) / (q - p) * (b.end - b.begin); };
  const double middle = (found.from_m + found.to_m) / 2;
  const double offset = cross(along, on_b(middle) - a.begin);
  found.distance_m = std::abs(offset);
  found.is_left = offset > 0;
  if (found.distance_m <= options.join_m || found.distance_m > options.max_wall_thickness_m) return std::nullopt;
  found.between = {a.begin + found.from_m * along, a.begin + found.to_m * along, on_b(found.to_m), on_b(found.from_m)};
  return found;
}

std::vector<bool> to_find(const PlanStrokes& strokes) {
  std::vector<bool> found;
  for (const PlanEdge& edge : strokes.edges)
    found.push_back(std::any_of(edge.lines.begin(), edge.lines.end(), [&](int line) {
      return strokes.paths[static_cast<std::size_t>(line)].sides == PlanSides::to_find;
    }));
  return found;
}

std::vector<SideBySide> all_side_by_side(const PlanStrokes& strokes, const std::vector<bool>& takes_part,
                                         const PlanOptions& options) {
  std::vector<PlanBoxes::Box> boxes;
  for (const PlanEdge& edge : strokes.edges)
    boxes.push_back(PlanBoxes::around(strokes.at(edge.from), strokes.at(edge.to), 0));
  const PlanBoxes index(boxes);
  std::vector<SideBySide> all;
  for (std::size_t k = 0; k < strokes.edges.size(); ++k) {
    if (!takes_part[k]) continue;
    const Segment segment = strokes.segment(strokes.edges[k]);
    std::vector<int> others;
    index.visit(PlanBoxes::around(segment.begin, segment.end, options.max_wall_thickness_m), [&](int other) {
      if (other != static_cast<int>(k) && takes_part[static_cast<std::size_t>(other)]) others.push_back(other);
    });
    std::sort(others.begin(), others.end());
    for (const int other : others)
      if (auto found =
              side_by_side(segment, strokes.segment(strokes.edges[static_cast<std::size_t>(other)]), options)) {
        found->edge = static_cast<int>(k);
        found->other = other;
        all.push_back(*found);
      }
  }
  return all;
}

/// Of two runs together.
struct Overlap {
  double length_m = 0;
  double distance_m = 1e9;
  bool is_enough() const { return length_m >= kMinOverlapByDistance * distance_m; }
};

/// Tells niches between two walls from walls: both have lines side by side.
class Niches {
 public:
  /// @param pairs  all stretches that may have wall between them.
  explicit Niches(const std::vector<SideBySide>& pairs) : pairs_(pairs), is_niche_(pairs.size()) {
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (const std::size_t k : order) {
      beside_[{pairs[k].edge, pairs[k].is_left}].push_back(k);
      number_[{pairs[k].edge, pairs[k].other}] = k;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return pairs[a].distance_m < pairs[b].distance_m; });
    for (const std::size_t k : order)
      if (pairs[k].distance_m >= kMinNiche_m) is_niche_[k] = is_between_walls(k) || reaches_over_niche(k);
  }

  bool contains(std::size_t pair) const { return is_niche_[pair] || (has_reverse(pair) && is_niche_[reverse(pair)]); }

 private:
  bool has_reverse(std::size_t k) const { return number_.contains({pairs_[k].other, pairs_[k].edge}); }
  std::size_t reverse(std::size_t k) const { return number_.at({pairs_[k].other, pairs_[k].edge}); }

  bool is_between_walls(std::size_t k) const {
    return has_reverse(k) && is_face_of_thinner_wall(k) && is_face_of_thinner_wall(reverse(k));
  }

  /// Whether the edge has a much nearer partner on its other side.
  bool is_face_of_thinner_wall(std::size_t k) const {
    const SideBySide& gap = pairs_[k];
    double along_m = 0;
    for (const std::size_t wall : on_side(gap.edge, !gap.is_left))
      if (pairs_[wall].distance_m <= kMaxWallByNiche * gap.distance_m)
        along_m = std::max(along_m, shared_m(pairs_[wall], gap));
    return along_m >= kMinWallAlongNiche * (gap.to_m - gap.from_m);
  }

  /// Whether what lies between its lines is a wall and a niche behind it.
  bool reaches_over_niche(std::size_t k) const {
    const SideBySide& gap = pairs_[k];
    const std::vector<std::size_t>& near = on_side(gap.edge, gap.is_left);
    return std::any_of(near.begin(), near.end(), [&](std::size_t wall) {
      if (pairs_[wall].distance_m >= gap.distance_m) return false;
      const auto behind = number_.find({pairs_[wall].other, gap.other});
      return behind != number_.end() && contains(behind->second) &&
             shared_m(pairs_[wall], gap) >= kMinWallAlongNiche * (gap.to_m - gap.from_m);
    });
  }

  const std::vector<std::size_t>& on_side(int edge, bool is_left) const {
    static const std::vector<std::size_t> kNone;
    const auto found = beside_.find({edge, is_left});
    return found == beside_.end() ? kNone : found->second;
  }

  static double shared_m(const SideBySide& a, const SideBySide& b) {
    return std::min(a.to_m, b.to_m) - std::max(a.from_m, b.from_m);
  }

  const std::vector<SideBySide>& pairs_;
  std::vector<bool> is_niche_;
  std::map<std::pair<int, bool>, std::vector<std::size_t>> beside_;  ///< by edge and side
  std::map<std::pair<int, int>, std::size_t> number_;                ///< by edge and other edge
};

/// Ends of the covered stretches of one edge on one side. Gaps up to the thickness of a wall, where one abuts, do not
/// count, nor do ends as near as that to the edge's own: there is a corner.
void add_ends(PlanPairs& pairs, int number, const Segment& edge, std::vector<std::pair<double, double>> covered,
              double thickness_m) {
  std::sort(covered.begin(), covered.end());
  std::vector<std::pair<double, double>> joined;
  for (const auto& stretch : covered)
    if (!joined.empty() && stretch.first - joined.back().second <= thickness_m)
      joined.back().second = std::max(joined.back().second, stretch.second);
    else
      joined.push_back(stretch);
  for (const auto& [from_m, to_m] : joined)
    for (const double at : {from_m, to_m})
      if (at > thickness_m && at < edge.length_m() - thickness_m)
        pairs.ends.emplace_back(number, edge.begin + at * edge.direction());
}

}  // namespace

PlanPairs find_pairs(const PlanStrokes& strokes, const PlanOptions& options) {
  const std::vector<bool> takes_part = to_find(strokes);
  Runs runs(strokes, takes_part);
  const std::vector<SideBySide> all = all_side_by_side(strokes, takes_part, options);
  std::map<std::pair<int, int>, Overlap> overlaps;
  for (const SideBySide& one : all) {
    Overlap& overlap = overlaps[{runs.of(one.edge), runs.of(one.other)}];
    overlap.length_m += one.to_m - one.from_m;
    overlap.distance_m = std::min(overlap.distance_m, one.distance_m);
  }
  std::vector<SideBySide> enough;
  for (const SideBySide& one : all) {
    const int run = runs.of(one.edge), other = runs.of(one.other);
    if (run != other && overlaps[{run, other}].is_enough()) enough.push_back(one);
  }
  const Niches niches(enough);
  PlanPairs pairs;
  std::map<std::pair<int, bool>, std::vector<std::pair<double, double>>> covered;
  for (std::size_t k = 0; k < enough.size(); ++k) {
    if (niches.contains(k)) continue;
    const SideBySide& one = enough[k];
    pairs.walls.push_back(one.between);
    covered[{one.edge, one.is_left}].emplace_back(one.from_m, one.to_m);
  }
  for (const auto& [edge_and_side, stretches] : covered)
    add_ends(pairs, edge_and_side.first, strokes.segment(strokes.edges[static_cast<std::size_t>(edge_and_side.first)]),
             stretches, options.max_wall_thickness_m);
  return pairs;
}

}  // namespace opal
