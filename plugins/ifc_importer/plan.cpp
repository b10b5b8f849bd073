#include "plan.hpp"

#include "gap_closing.hpp"
#include "line_mesh.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace opal::ifc_importer {
namespace {

// After gaps are closed, what still lies so near is one.
constexpr double kSame_m = 0.002;
// Faces of one solid that turn by less are one face.
constexpr double kStraight_m = 0.003;
// A hollow smaller than this holds no robot.
constexpr double kSmallestRoom_m2 = 0.25;

struct Line {
  int solid;
  int circle;  ///< number, or -1
};

class Union {
 public:
  explicit Union(const std::vector<PlanSolid>& solids) : solids_(with_gaps_closed(solids)) {
    for (std::size_t k = 0; k < solids_.size(); ++k) {
      for (const Loop& loop : solids_[k].loops) add(loop, static_cast<int>(k));
      insides_.push_back(inside_of(solids_[k].loops));
    }
  }

  Plan run() {
    const LineMesh mesh(segments_, kSame_m);
    std::vector<LineMesh::Edge> visible;
    std::vector<PlanFace> faces;
    for (const LineMesh::Edge& edge : mesh.edges()) add_if_visible(mesh, edge, visible, faces);
    Plan plan;
    plan.nodes = mesh.nodes();
    for (const std::vector<std::size_t>& chain : closed_chains(mesh, visible)) {
      std::vector<PlanFace> joined;
      for (const std::size_t k : chain) joined.push_back(faces[k]);
      if (is_closed_void(plan, joined))
        ++plan.closed_voids;
      else
        plan.chains.push_back(joined_straight(plan, joined));
    }
    measure_circles(plan);
    return plan;
  }

 private:
  void add(const Loop& loop, int solid) {
    int number = -1;
    if (const std::optional<Circle> circle = circle_of(loop); circle && area_m2(loop) > 0) {
      number = static_cast<int>(circles_.size());
      circles_.push_back({solid, *circle, 0});
    }
    for (const Segment& segment : segments_of({loop})) {
      if (segment.length_m() <= kSame_m) continue;
      segments_.push_back(segment);
      lines_.push_back({solid, number});
    }
  }

  struct Sides {
    bool left = false, right = false;
    int left_line = -1, right_line = -1;  ///< of the first solid on that side whose border runs here
  };

  Sides sides_of(const LineMesh& mesh, const LineMesh::Edge& edge) const {
    std::map<int, std::pair<int, int>> here;  // lines along and against, by solid; -1: none
    for (const int line : edge.along)
      here.try_emplace(lines_[static_cast<std::size_t>(line)].solid, -1, -1).first->second.first = line;
    for (const int line : edge.against)
      here.try_emplace(lines_[static_cast<std::size_t>(line)].solid, -1, -1).first->second.second = line;
    Sides sides;
    for (const auto& [solid, lines] : here) {
      if (lines.first >= 0 && lines.second >= 0) continue;  // folded flat: nothing of it is left here
      if (lines.first >= 0 && !std::exchange(sides.left, true)) sides.left_line = lines.first;
      if (lines.second >= 0 && !std::exchange(sides.right, true)) sides.right_line = lines.second;
    }
    if (sides.left == sides.right) return sides;
    const Point middle = mesh.segment(edge).midpoint();
    for (std::size_t k = 0; k < insides_.size() && sides.left != sides.right; ++k)
      if (!here.count(static_cast<int>(k)) && insides_[k].contains(middle)) sides.left = sides.right = true;
    return sides;
  }

  void add_if_visible(const LineMesh& mesh, const LineMesh::Edge& edge, std::vector<LineMesh::Edge>& visible,
                      std::vector<PlanFace>& faces) {
    const Sides sides = sides_of(mesh, edge);
    if (sides.left == sides.right) return;
    const Line& line = lines_[static_cast<std::size_t>(sides.left ? sides.left_line : sides.right_line)];
    const int begin = sides.left ? edge.to : edge.from, end = sides.left ? edge.from : edge.to;
    visible.push_back({begin, end});
    faces.push_back({line.solid, begin, end, line.circle >= 0});
    if (line.circle >= 0)
      circles_[static_cast<std::size_t>(line.circle)].visible_share += mesh.segment(edge).length_m();
  }

  static Point at(const Plan& plan, int node) { return plan.nodes[static_cast<std::size_t>(node)]; }

  static bool is_closed_void(const Plan& plan, const std::vector<PlanFace>& chain) {
    Loop loop;
    for (const PlanFace& face : chain) loop.push_back(at(plan, face.begin));
    const double area = area_m2(loop);
    return area > 0 && area < kSmallestRoom_m2;
  }

  int object_of(const PlanFace& face) const { return solids_[static_cast<std::size_t>(face.owner)].object; }

  bool goes_on(const Plan& plan, const PlanFace& a, const PlanFace& b) const {
    if (object_of(a) != object_of(b) || a.is_round || b.is_round) return false;
    const Point way = at(plan, b.end) - at(plan, a.begin), to_middle = at(plan, b.begin) - at(plan, a.begin);
    return way.norm() > kSame_m && std::abs(cross(way.normalized(), to_middle)) < kStraight_m &&
           to_middle.dot(way) > 0 && (at(plan, b.end) - at(plan, b.begin)).dot(way) > 0;
  }

  std::vector<PlanFace> joined_straight(const Plan& plan, const std::vector<PlanFace>& chain) const {
    std::vector<PlanFace> joined;
    for (const PlanFace& face : chain) {
      if (!joined.empty() && goes_on(plan, joined.back(), face))
        joined.back().end = face.end;
      else
        joined.push_back(face);
    }
    if (joined.size() > 2 && goes_on(plan, joined.back(), joined.front())) {
      joined.front().begin = joined.back().begin;
      joined.pop_back();
    }
    return joined;
  }

  void measure_circles(Plan& plan) const {
    for (PlanCircle circle : circles_) {
      circle.visible_share /= 2 * std::numbers::pi * circle.circle.radius_m;
      plan.circles.push_back(circle);
    }
  }

  std::vector<PlanSolid> solids_;
  std::vector<Region> insides_;
  std::vector<Segment> segments_;
  std::vector<Line> lines_;
  std::vector<PlanCircle> circles_;
};

}  // namespace

Plan unite(const std::vector<PlanSolid>& solids) { return Union(solids).run(); }

}  // namespace opal::ifc_importer
