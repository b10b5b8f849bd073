#include "closed_doors.hpp"

#include <opal/map/perceivable_faces.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace opal::dxf_importer {
namespace {

// A leaf is drawn as a line or as a thin rectangle beside its hinge; of its width.
constexpr double kNearHinge = 0.12;
constexpr double kMinLeaf_m = 0.4, kMaxLeaf_m = 3;
// A leaf is hung on either face of a wall or between them.
constexpr double kWithinWall_m = 0.3;
constexpr double kParallel_rad = 0.15;
constexpr double kBeyond_m = 0.05;
// A frame is no wider.
constexpr double kJamb_m = 0.12;
constexpr double kMinSweep_rad = 0.7, kMaxSweep_rad = 3.3;
constexpr double kOffArc = 0.03;

bool is_width_of_leaf(double length_m) { return length_m >= kMinLeaf_m && length_m <= kMaxLeaf_m; }

std::optional<Point> centre_through(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a, ac = c - a;
  const double twice_area = cross(ab, ac);
  if (std::abs(twice_area) < 1e-3 * ac.squaredNorm()) return std::nullopt;
  return a + Point(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                   ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) /
                 (2 * twice_area);
}

/// Straight pieces of strokes, found by their ends.
class Leaves {
 public:
  explicit Leaves(const std::vector<DoorStroke>& strokes) {
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      if (swing_of(strokes[k].points)) continue;
      for (std::size_t i = 0; i + 1 < strokes[k].points.size(); ++i) {
        const Point &a = strokes[k].points[i], &b = strokes[k].points[i + 1];
        if (!is_width_of_leaf((b - a).norm())) continue;
        pieces_.emplace(a.x(), Piece{k, a, b});
        pieces_.emplace(b.x(), Piece{k, b, a});
      }
    }
  }

  /// The strokes that have a leaf from the hinge to this tip.
  std::vector<std::size_t> between(const Point& hinge, const Point& tip) const {
    const double near_m = kNearHinge * (tip - hinge).norm();
    std::vector<std::size_t> found;
    const auto end = pieces_.upper_bound(hinge.x() + near_m);
    for (auto it = pieces_.lower_bound(hinge.x() - near_m); it != end; ++it)
      if ((it->second.from - hinge).norm() <= near_m && (it->second.to - tip).norm() <= near_m)
        found.push_back(it->second.stroke);
    return found;
  }

 private:
  struct Piece {
    std::size_t stroke = 0;
    Point from, to;
  };
  std::multimap<double, Piece> pieces_;  ///< by x of `from`
};

class Walls {
 public:
  explicit Walls(const SemanticMap& map) : faces_(perceivable_faces(map)) {}

  /// Whether a wall runs along all of the way from a to b.
  /// @param beyond  and past both ends: a wall that only begins or ends there has an opening beside it.
  bool close(const Point& a, const Point& b, bool beyond) const {
    const Point along = (b - a).normalized();
    std::vector<Point> places;
    for (const double share : {0.25, 0.5, 0.75}) places.push_back(a + share * (b - a));
    if (beyond) places.insert(places.end(), {a - kBeyond_m * along, b + kBeyond_m * along});
    std::vector<const Segment*> near;
    for (const Segment& face : faces_)
      if (std::abs(cross(along, face.direction())) <= kParallel_rad &&
          distance_m(face, a + 0.5 * (b - a)) <= kWithinWall_m + (b - a).norm())
        near.push_back(&face);
    return std::all_of(places.begin(), places.end(), [&](const Point& place) {
      return std::any_of(near.begin(), near.end(), [&](const Segment* face) { return passes(*face, place); });
    });
  }

  /// Whether the way from the hinge to the jamb is free and a wall goes on in line with it behind the jamb.
  bool opens(const Point& hinge, const Point& jamb) const {
    const Point along = (jamb - hinge).normalized();
    return !close(hinge, jamb, false) && close(jamb + kJamb_m * along, jamb + (kJamb_m + kBeyond_m) * along, false);
  }

 private:
  static bool passes(const Segment& face, const Point& place) {
    const Point to = place - face.begin;
    const double at_m = face.direction().dot(to);
    return at_m >= 0 && at_m <= face.length_m() && std::abs(cross(face.direction(), to)) <= kWithinWall_m;
  }

  std::vector<Segment> faces_;
};

class ClosedDoors {
 public:
  ClosedDoors(const std::vector<DoorStroke>& strokes, const SemanticMap& map)
      : strokes_(strokes), leaves_(strokes), walls_(map) {}

  std::vector<std::string> run() {
    for (const DoorStroke& stroke : strokes_)
      if (const auto swing = swing_of(stroke.points); swing && is_width_of_leaf(swing->radius_m()))
        judge(stroke, *swing);
    judge_straight_doors();
    std::vector<std::string> ids;
    std::set<std::string> known;
    for (const DoorStroke& stroke : strokes_)
      if (closed_.contains(stroke.id) && known.insert(stroke.id).second) ids.push_back(stroke.id);
    return ids;
  }

 private:
  /// A leaf is drawn open, so the arc's other end is where it shuts. Without exactly one leaf, either end may be that.
  void judge(const DoorStroke& stroke, const DoorSwing& swing) {
    swinging_.insert(stroke.id);
    const auto at_begin = leaves_.between(swing.hinge, swing.begin), at_end = leaves_.between(swing.hinge, swing.end);
    for (const auto& leaves : {at_begin, at_end})
      for (const std::size_t leaf : leaves) swinging_.insert(strokes_[leaf].id);
    if (!stroke.is_door && at_begin.empty() && at_end.empty()) return;
    const bool is_known = at_begin.empty() != at_end.empty();
    const bool may_shut_at_begin = !is_known || at_begin.empty(), may_shut_at_end = !is_known || at_end.empty();
    if ((may_shut_at_begin && is_walled(swing.hinge, swing.begin, swing.end, !is_known)) ||
        (may_shut_at_end && is_walled(swing.hinge, swing.end, swing.begin, !is_known)))
      closed_.insert(stroke.id);
  }

  /// Whether a wall goes on where the leaf shuts. Not if the arc's other end lies at an opening: then the leaf is drawn
  /// shut, and the wall is one that it opens to.
  bool is_walled(const Point& hinge, const Point& shut, const Point& open, bool beyond) const {
    return walls_.close(hinge, shut, beyond) && !walls_.opens(hinge, open);
  }

  /// Doors without a swing: all of their lines run in the wall.
  void judge_straight_doors() {
    std::map<std::string, bool> is_walled;
    for (const DoorStroke& stroke : strokes_) {
      if (!stroke.is_door || swinging_.contains(stroke.id)) continue;
      for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
        const Point &a = stroke.points[i], &b = stroke.points[i + 1];
        if (!is_width_of_leaf((b - a).norm())) continue;
        const bool is_here = walls_.close(a, b, true);
        const auto [known, is_new] = is_walled.emplace(stroke.id, is_here);
        known->second = known->second && is_here;
      }
    }
    for (const auto& [id, is_closed] : is_walled)
      if (is_closed) closed_.insert(id);
  }

  const std::vector<DoorStroke>& strokes_;
  Leaves leaves_;
  Walls walls_;
  std::set<std::string> swinging_;  ///< ids of doors with a swing, and of leaves of one
  std::set<std::string> closed_;
};

}  // namespace

std::optional<DoorSwing> swing_of(const std::vector<Point>& points) {
  if (points.size() < 4) return std::nullopt;
  const auto centre = centre_through(points.front(), points[points.size() / 2], points.back());
  if (!centre) return std::nullopt;
  const DoorSwing swing{*centre, points.front(), points.back()};
  double sweep_rad = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (std::abs((points[k] - *centre).norm() - swing.radius_m()) > kOffArc * swing.radius_m()) return std::nullopt;
    if (k == 0) continue;
    const Point from = points[k - 1] - *centre, to = points[k] - *centre;
    sweep_rad += std::atan2(cross(from, to), from.dot(to));
  }
  if (std::abs(sweep_rad) < kMinSweep_rad || std::abs(sweep_rad) > kMaxSweep_rad) return std::nullopt;
  return swing;
}

std::vector<std::string> closed_doors(const std::vector<DoorStroke>& strokes, const SemanticMap& map) {
  return ClosedDoors(strokes, map).run();
}

}  // namespace opal::dxf_importer
