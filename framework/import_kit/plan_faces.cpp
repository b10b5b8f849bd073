#include "import_kit/plan_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace opal {
namespace {

constexpr double kStraight_rad = 0.01;

/// An edge in one direction; number 2 k is edge k from `from` to `to`, 2 k + 1 the other way.
class HalfEdges {
 public:
  HalfEdges(const PlanStrokes& strokes, const std::vector<EdgeSides>& sides)
      : strokes_(strokes), sides_(sides), around_(strokes.nodes.size()) {
    for (int half = 0; half < size(); ++half)
      if (!sides[static_cast<std::size_t>(half / 2)].is_hidden())
        around_[static_cast<std::size_t>(from(half))].push_back(half);
  }

  int size() const { return 2 * static_cast<int>(sides_.size()); }
  const PlanEdge& edge(int half) const { return strokes_.edges[static_cast<std::size_t>(half / 2)]; }
  int from(int half) const { return half % 2 == 0 ? edge(half).from : edge(half).to; }
  int to(int half) const { return half % 2 == 0 ? edge(half).to : edge(half).from; }
  bool is_seen(int half) const {
    const EdgeSides& sides = sides_[static_cast<std::size_t>(half / 2)];
    return half % 2 == 0 ? sides.left : sides.right;
  }
  double heading_rad(int half) const {
    const Point along = strokes_.at(to(half)) - strokes_.at(from(half));
    return std::atan2(along.y(), along.x());
  }

  /// The seen half-edge that bounds the free space on the left of this one at its end; -1 if there is none.
  int next(int half) const {
    const double back_rad = heading_rad(half ^ 1);
    int best = -1;
    double best_rad = std::numeric_limits<double>::infinity();
    for (const int other : around_[static_cast<std::size_t>(to(half))]) {
      double clockwise_rad = wrap_angle(back_rad - heading_rad(other));
      if (clockwise_rad <= 0 || other == (half ^ 1)) clockwise_rad += 2 * std::numbers::pi;
      if (clockwise_rad < best_rad) {
        best_rad = clockwise_rad;
        best = other;
      }
    }
    return best >= 0 && is_seen(best) && best != (half ^ 1) ? best : -1;
  }

 private:
  const PlanStrokes& strokes_;
  const std::vector<EdgeSides>& sides_;
  std::vector<std::vector<int>> around_;  ///< half-edges that are not hidden, by the node that they leave
};

/// The directions in which a straight line from a point goes by all points so far.
class Straight {
 public:
  Straight(const Point& from, double tolerance_m) : from_(from), tolerance_m_(tolerance_m) {}

  /// Takes `passed` in. @return whether the line to `end` goes by it and all before.
  bool goes_by(const Point& passed, const Point& end) {
    const Point way = passed - from_;
    if (!middle_rad_) middle_rad_ = std::atan2(way.y(), way.x());
    const double half_rad = std::atan2(tolerance_m_, way.norm());
    low_rad_ = std::max(low_rad_, turn_rad(way) - half_rad);
    high_rad_ = std::min(high_rad_, turn_rad(way) + half_rad);
    return low_rad_ <= turn_rad(end - from_) && turn_rad(end - from_) <= high_rad_;
  }

 private:
  double turn_rad(const Point& way) const { return wrap_angle(std::atan2(way.y(), way.x()) - *middle_rad_); }

  Point from_;
  double tolerance_m_;
  std::optional<double> middle_rad_;
  double low_rad_ = -1, high_rad_ = 1;
};

class FaceJoining {
 public:
  FaceJoining(const PlanStrokes& strokes, const std::vector<EdgeSides>& sides, const std::vector<PlanElement>& elements,
              double join_m)
      : strokes_(strokes), elements_(elements), join_m_(join_m), halves_(strokes, sides) {
    for (int half = 0; half < halves_.size(); ++half) next_.push_back(halves_.is_seen(half) ? halves_.next(half) : -1);
    face_of_.assign(next_.size(), -1);
    goes_on_from_.assign(next_.size(), false);
    for (int half = 0; half < halves_.size(); ++half)
      if (goes_on(half)) goes_on_from_[static_cast<std::size_t>(next(half))] = true;
  }

  std::vector<PlanFace> run() {
    for (int half = 0; half < halves_.size(); ++half)
      if (halves_.is_seen(half) && !goes_on_from_[static_cast<std::size_t>(half)]) walk(half);
    for (int half = 0; half < halves_.size(); ++half)
      if (halves_.is_seen(half) && face_of_[static_cast<std::size_t>(half)] < 0) walk(half);
    for (std::size_t k = 0; k < faces_.size(); ++k)
      if (const int after = next(last_[k]); after >= 0) faces_[k].next = face_of_[static_cast<std::size_t>(after)];
    return std::move(faces_);
  }

 private:
  int next(int half) const { return next_[static_cast<std::size_t>(half)]; }
  const PlanPath& path(int line) const { return strokes_.paths[static_cast<std::size_t>(line)]; }
  const PlanElement& element(int line) const { return elements_[static_cast<std::size_t>(path(line).element)]; }

  /// Pieces of one element, or of two that both run along one of the pieces; drawn lines of one type in any case.
  bool may_join(int half, int other) const {
    for (const int a : halves_.edge(half).lines)
      for (const int b : halves_.edge(other).lines)
        if (path(a).element == path(b).element) return true;
    const int a = halves_.edge(half).lines.front(), b = halves_.edge(other).lines.front();
    const bool both_drawn = path(a).sides != PlanSides::solid && path(b).sides != PlanSides::solid;
    return both_drawn && element(a).type == element(b).type && element(a).sensor == element(b).sensor;
  }

  bool goes_on(int half) const {
    const int after = next(half);
    return after >= 0 && may_join(half, after) &&
           std::abs(wrap_angle(halves_.heading_rad(after) - halves_.heading_rad(half))) < kStraight_rad;
  }

  /// As far as it is straight as a whole: a large circle's chords are not.
  void walk(int first) {
    begin_face(first);
    Straight straight(strokes_.at(halves_.from(first)), join_m_ / 2);
    for (int half = first; goes_on(half) && face_of_[static_cast<std::size_t>(next(half))] < 0; half = next(half)) {
      if (straight.goes_by(strokes_.at(halves_.to(half)), strokes_.at(halves_.to(next(half))))) {
        add_to_face(next(half));
      } else {
        begin_face(next(half));
        straight = Straight(strokes_.at(halves_.from(next(half))), join_m_ / 2);
      }
    }
  }

  void begin_face(int half) {
    faces_.push_back({halves_.from(half), halves_.to(half), path(halves_.edge(half).lines.front()).element, {}, -1});
    last_.push_back(half);
    add_to_face(half);
  }

  void add_to_face(int half) {
    PlanFace& face = faces_.back();
    face.to = halves_.to(half);
    last_.back() = half;
    face_of_[static_cast<std::size_t>(half)] = static_cast<int>(faces_.size()) - 1;
    std::set<int> all(face.others.begin(), face.others.end());
    all.insert(face.element);
    for (const int line : halves_.edge(half).lines) all.insert(path(line).element);
    face.element = *all.begin();
    face.others.assign(std::next(all.begin()), all.end());
  }

  const PlanStrokes& strokes_;
  const std::vector<PlanElement>& elements_;
  double join_m_;
  HalfEdges halves_;
  std::vector<int> next_;
  std::vector<int> face_of_;
  std::vector<bool> goes_on_from_;
  std::vector<PlanFace> faces_;
  std::vector<int> last_;  ///< half-edge of each face
};

}  // namespace

std::vector<PlanFace> join_faces(const PlanStrokes& strokes, const std::vector<EdgeSides>& sides,
                                 const std::vector<PlanElement>& elements, double join_m) {
  return FaceJoining(strokes, sides, elements, join_m).run();
}

}  // namespace opal
