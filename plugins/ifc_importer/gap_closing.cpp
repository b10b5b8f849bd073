#include "gap_closing.hpp"

#include "point_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace opal::ifc_importer {
namespace {

constexpr double kClosed_m = 0.0101;
constexpr double kOwnCorners_m = 0.001;

struct Edge {
  int from, to, solid;
};

struct Corner {
  Point at, to_previous, to_next;
};

class GapClosing {
 public:
  explicit GapClosing(const std::vector<PlanSolid>& solids) : solids_(solids), nodes_(kClosed_m) {}

  std::vector<PlanSolid> run() {
    for (std::size_t k = 0; k < solids_.size(); ++k)
      for (const Loop& loop : solids_[k].loops) add(loop, static_cast<int>(k));
    for (const std::vector<Corner>& corners : corners_) settled_.push_back(best_place(corners));
    positions_ = settled_;
    move_to_faces();
    return moved();
  }

 private:
  void add(const Loop& loop, int solid) {
    loops_.push_back({solid, {}, circle_of(loop).has_value()});
    const bool is_sheet = is_thinner_than_gap(loop);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point& p = loop[k];
      const int node = loops_.back().is_round ? nodes_.add(p) : node_for(p, solid);
      loops_.back().nodes.push_back(node);
      users_.resize(nodes_.points().size());
      if (is_sheet) users_[static_cast<std::size_t>(node)].insert(solid);
      corners_.resize(nodes_.points().size());
      corners_[static_cast<std::size_t>(node)].push_back(
          {p, loop[(k + loop.size() - 1) % loop.size()] - p, loop[(k + 1) % loop.size()] - p});
    }
    for (const int node : loops_.back().nodes)
      users_[static_cast<std::size_t>(node)].insert(loops_.back().is_round ? kNobody : solid);
  }

  /// Its two sides must not become one, as the ends of a chamfer do.
  static bool is_thinner_than_gap(const Loop& loop) {
    double around_m = 0;
    for (const Segment& s : segments_of({loop})) around_m += s.length_m();
    return 2 * std::abs(area_m2(loop)) < kClosed_m * around_m;
  }

  int node_for(const Point& p, int solid) {
    int best = -1;
    double best_m = 2 * kClosed_m;
    nodes_.visit_near(p, [&](int node) {
      const double distance_m = (nodes_.points()[static_cast<std::size_t>(node)] - p).norm();
      const auto& users = users_[static_cast<std::size_t>(node)];
      const bool may = users.count(kNobody) == 0 && (users.count(solid) == 0 || distance_m < kOwnCorners_m);
      if (may && distance_m < best_m) best = node, best_m = distance_m;
    });
    return best >= 0 ? best : nodes_.add(p);
  }

  /// What it does to a corner's two faces if it is moved: how far they tilt, long ones more than short ones.
  static double tilt(const Corner& corner, const Point& to) {
    return std::abs(cross(corner.to_previous, to - corner.at)) + std::abs(cross(corner.to_next, to - corner.at));
  }

  static Point best_place(const std::vector<Corner>& corners) {
    Point best = corners.front().at;
    double least = std::numeric_limits<double>::infinity();
    for (const Corner& candidate : corners) {
      double all = 0;
      for (const Corner& corner : corners) all += tilt(corner, candidate.at);
      if (all < least - 1e-9) least = all, best = candidate.at;
    }
    return best;
  }

  Segment segment(const Edge& edge) const {
    return {settled_[static_cast<std::size_t>(edge.from)], settled_[static_cast<std::size_t>(edge.to)]};
  }

  /// A corner goes onto the face of another solid that it nearly touches; onto the meeting of two, if there are two.
  void move_to_faces() {
    std::map<int, std::vector<Edge>> near;
    for (const SolidLoop& loop : loops_)
      for (std::size_t k = 0; !loop.is_round && k < loop.nodes.size(); ++k)
        visit_nodes_near({loop.nodes[k], loop.nodes[(k + 1) % loop.nodes.size()], loop.solid},
                         [&](int node, const Edge& edge) { near[node].push_back(edge); });
    for (const auto& [node, edges] : near) move(node, edges);
  }

  template <class Visit>
  void visit_nodes_near(const Edge& edge, Visit visit) {
    const Segment s = segment(edge);
    if (edge.from == edge.to || s.length_m() < 3 * kClosed_m) return;
    if (by_x_.empty()) {
      for (std::size_t k = 0; k < settled_.size(); ++k) by_x_.push_back({settled_[k].x(), static_cast<int>(k)});
      std::sort(by_x_.begin(), by_x_.end());
    }
    const auto [low, high] = std::minmax(s.begin.x(), s.end.x());
    for (auto it = std::lower_bound(by_x_.begin(), by_x_.end(), std::pair(low - kClosed_m, -1));
         it != by_x_.end() && it->first <= high + kClosed_m; ++it) {
      const auto& users = users_[static_cast<std::size_t>(it->second)];
      const Point& p = settled_[static_cast<std::size_t>(it->second)];
      if (users.count(edge.solid) || users.count(kNobody) || distance_m(s, p) > kClosed_m) continue;
      const double along = s.direction().dot(p - s.begin);
      if (along > kClosed_m && along < s.length_m() - kClosed_m) visit(it->second, edge);
    }
  }

  void move(int node, const std::vector<Edge>& edges) {
    Point& p = positions_[static_cast<std::size_t>(node)];
    const Segment first = segment(edges.front());
    Point onto = first.begin + first.direction() * first.direction().dot(p - first.begin);
    for (const Edge& edge : edges) {
      const Segment other = segment(edge);
      const double sine = cross(first.direction(), other.direction());
      if (std::abs(sine) < 0.5) continue;
      const Point meeting =
          first.begin + first.direction() * (cross(other.begin - first.begin, other.direction()) / sine);
      if ((meeting - p).norm() <= 2 * kClosed_m) onto = meeting;
    }
    p = onto;
  }

  std::vector<PlanSolid> moved() const {
    std::vector<PlanSolid> solids(solids_.size());
    for (std::size_t k = 0; k < solids.size(); ++k) solids[k].object = solids_[k].object;
    for (const SolidLoop& loop : loops_) {
      Loop points;
      for (std::size_t k = 0; k < loop.nodes.size(); ++k)
        if (loop.nodes[k] != loop.nodes[(k + 1) % loop.nodes.size()])
          points.push_back(positions_[static_cast<std::size_t>(loop.nodes[k])]);
      if (points.size() >= 3) solids[static_cast<std::size_t>(loop.solid)].loops.push_back(std::move(points));
    }
    return solids;
  }

  struct SolidLoop {
    int solid;
    std::vector<int> nodes;
    bool is_round;
  };
  static constexpr int kNobody = -1;  // corners of circles belong to nobody: they stay

  const std::vector<PlanSolid>& solids_;
  PointNodes nodes_;
  std::vector<std::set<int>> users_;
  std::vector<SolidLoop> loops_;
  std::vector<std::pair<double, int>> by_x_;
  std::vector<std::vector<Corner>> corners_;  // by node
  std::vector<Point> settled_;                // nodes, before any moves to a face
  std::vector<Point> positions_;              // and after
};

}  // namespace

std::vector<PlanSolid> with_gaps_closed(const std::vector<PlanSolid>& solids) { return GapClosing(solids).run(); }

}  // namespace opal::ifc_importer
