#include "import_kit/plan_strokes.hpp"

#include "import_kit/plan_boxes.hpp"
#include "import_kit/plan_nodes.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace opal {
namespace {

constexpr double kMaxCoordinate_m = 1e6;
constexpr std::size_t kMaxStrokes = 400'000;
constexpr std::size_t kMaxCrossings = 4'000'000;
constexpr double kParallelSine = 1e-9;

struct Stroke {
  Segment segment;
  int path = 0;
};

void check(const std::string& name, const PlanElement& element, const Point& p) {
  if (p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxCoordinate_m) return;
  throw MapError(name + ": '" + element.id + "' is at (" + std::to_string(p.x()) + ", " + std::to_string(p.y()) +
                 "), expected coordinates within 1e6 m of the origin");
}

void check(const std::string& name, const PlanElement& element) {
  for (const PlanLine& line : element.lines)
    for (const Point& p : line.points) check(name, element, p);
  for (const Circle& circle : element.circles) {
    check(name, element, circle.center);
    check(name, element, Point(circle.radius_m, 0));
  }
}

std::optional<Point> crossing(const Segment& a, const Segment& b) {
  const Point along_a = a.end - a.begin, along_b = b.end - b.begin;
  const double sine = cross(along_a, along_b);
  if (std::abs(sine) <= kParallelSine * along_a.norm() * along_b.norm()) return std::nullopt;
  const double on_a = cross(b.begin - a.begin, along_b) / sine, on_b = cross(b.begin - a.begin, along_a) / sine;
  if (on_a < 0 || on_a > 1 || on_b < 0 || on_b > 1) return std::nullopt;
  return a.begin + on_a * along_a;
}

/// Where a stroke goes into or out of something round.
std::vector<Point> crossings(const Segment& stroke, const Circle& circle) {
  const Point along = stroke.direction();
  const double middle = along.dot(circle.center - stroke.begin);
  const double off = cross(along, circle.center - stroke.begin);
  const double half = circle.radius_m * circle.radius_m - off * off;
  std::vector<Point> places;
  if (half <= 0) return places;
  for (const double at : {middle - std::sqrt(half), middle + std::sqrt(half)})
    if (at > 0 && at < stroke.length_m()) places.push_back(stroke.begin + at * along);
  return places;
}

class Cutting {
 public:
  Cutting(const std::string& name, const std::vector<PlanElement>& elements, double join_m)
      : name_(name), elements_(elements), join_m_(join_m), nodes_(join_m) {
    for (std::size_t k = 0; k < elements.size(); ++k) {
      check(name, elements[k]);
      if (!elements[k].sensor.empty()) add(elements[k], static_cast<int>(k));
    }
  }

  PlanStrokes run() {
    for (const Stroke& stroke : strokes_) {
      nodes_.add(stroke.segment.begin);
      nodes_.add(stroke.segment.end);
    }
    add_crossings();
    collect_nodes();
    add_unseen();
    result_.nodes = nodes_.points();
    return std::move(result_);
  }

 private:
  void add(const PlanElement& element, int number) {
    for (const PlanLine& line : element.lines) {
      const int path = static_cast<int>(result_.paths.size());
      result_.paths.push_back({number, line.sides, line.closed, line.solid, {}});
      const std::size_t count = line.points.size();
      for (std::size_t k = 0; k + 1 < count + (line.closed ? 1 : 0); ++k)
        add({line.points[k], line.points[(k + 1) % count]}, path);
    }
    circles_.insert(circles_.end(), element.circles.begin(), element.circles.end());
  }

  void add(const Segment& segment, int path) {
    if (segment.begin == segment.end) return;
    if (strokes_.size() == kMaxStrokes)
      throw MapError(
          fmt::format("{}: more than {} straight strokes, expected a plan of one storey", name_, kMaxStrokes));
    strokes_.push_back({segment, path});
  }

  PlanBoxes::Box box(const Segment& segment) const { return PlanBoxes::around(segment.begin, segment.end, join_m_); }

  void add_crossings() {
    std::vector<PlanBoxes::Box> boxes;
    for (const Stroke& stroke : strokes_) boxes.push_back(box(stroke.segment));
    const PlanBoxes index(boxes);
    std::size_t tries = 0;
    for (std::size_t k = 0; k < strokes_.size(); ++k) {
      std::vector<int> others;
      index.visit(boxes[k], [&](int other) {
        if (++tries > 8 * kMaxCrossings) fail_too_many();
        if (other > static_cast<int>(k)) others.push_back(other);
      });
      std::sort(others.begin(), others.end());
      for (const int other : others)
        if (const auto p = crossing(strokes_[k].segment, strokes_[static_cast<std::size_t>(other)].segment))
          add_crossing(*p);
    }
    for (const Circle& circle : circles_) {
      const Point reach(circle.radius_m, circle.radius_m);
      std::vector<int> others;
      index.visit(PlanBoxes::around(circle.center - reach, circle.center + reach, 0),
                  [&](int other) { others.push_back(other); });
      std::sort(others.begin(), others.end());
      for (const int other : others)
        for (const Point& p : crossings(strokes_[static_cast<std::size_t>(other)].segment, circle)) add_crossing(p);
    }
  }

  [[noreturn]] void fail_too_many() const {
    throw MapError(fmt::format("{}: more than {} crossings of strokes, expected a plan", name_, kMaxCrossings));
  }

  void add_crossing(const Point& p) {
    if (++crossings_ > kMaxCrossings) fail_too_many();
    nodes_.add(p);
  }

  /// Every stroke becomes the nodes that lie on it, in order.
  void collect_nodes() {
    std::vector<PlanBoxes::Box> boxes;
    for (const Point& p : nodes_.points()) boxes.push_back(PlanBoxes::around(p, p, 0));
    const PlanBoxes index(boxes);
    for (const Stroke& stroke : strokes_)
      for (const int node : nodes_on(stroke.segment, index))
        append(result_.paths[static_cast<std::size_t>(stroke.path)], node);
    for (PlanPath& path : result_.paths)
      while (path.closed && path.nodes.size() > 1 && path.nodes.front() == path.nodes.back()) path.nodes.pop_back();
  }

  static void append(PlanPath& path, int node) {
    if (path.nodes.empty() || path.nodes.back() != node) path.nodes.push_back(node);
  }

  void add_unseen() {
    for (std::size_t k = 0; k < elements_.size(); ++k)
      for (const PlanLine& line : elements_[k].lines) {
        if (!elements_[k].sensor.empty()) continue;
        PlanPath path{static_cast<int>(k), line.sides, line.closed, line.solid, {}};
        for (const Point& p : line.points) append(path, nodes_.add(p));
        result_.unseen.push_back(std::move(path));
      }
  }

  std::vector<int> nodes_on(const Segment& segment, const PlanBoxes& index) {
    const int first = nodes_.add(segment.begin), last = nodes_.add(segment.end);
    std::vector<std::pair<double, int>> between;
    index.visit(box(segment), [&](int node) {
      if (node == first || node == last) return;
      const Point p = nodes_.points()[static_cast<std::size_t>(node)] - segment.begin;
      const double along = segment.direction().dot(p);
      if (along < join_m_ || along > segment.length_m() - join_m_) return;  // near the end without being it
      if (std::abs(cross(segment.direction(), p)) <= join_m_) between.emplace_back(along, node);
    });
    std::sort(between.begin(), between.end());
    std::vector<int> nodes{first};
    for (const auto& [along, node] : between) nodes.push_back(node);
    nodes.push_back(last);
    return nodes;
  }

  const std::string& name_;
  const std::vector<PlanElement>& elements_;
  double join_m_;
  PlanNodes nodes_;
  std::vector<Stroke> strokes_;
  std::vector<Circle> circles_;
  std::size_t crossings_ = 0;
  PlanStrokes result_;
};

std::uint64_t key_of(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
}

void collect_edges(PlanStrokes& strokes) {
  strokes.edges.clear();
  std::unordered_map<std::uint64_t, std::size_t> numbers;
  for (std::size_t line = 0; line < strokes.paths.size(); ++line) {
    const PlanPath& path = strokes.paths[line];
    const std::size_t count = path.nodes.size();
    for (std::size_t k = 0; k + 1 < count + (path.closed && count > 2 ? 1 : 0); ++k) {
      const int a = path.nodes[k], b = path.nodes[(k + 1) % count];
      const auto [entry, is_new] = numbers.try_emplace(key_of(a, b), strokes.edges.size());
      if (is_new) strokes.edges.push_back({std::min(a, b), std::max(a, b), {}});
      std::vector<int>& lines = strokes.edges[entry->second].lines;
      if (lines.empty() || lines.back() != static_cast<int>(line)) lines.push_back(static_cast<int>(line));
    }
  }
}

}  // namespace

PlanStrokes cut_strokes(const std::string& name, const std::vector<PlanElement>& elements, double join_m) {
  PlanStrokes strokes = Cutting(name, elements, join_m).run();
  collect_edges(strokes);
  return strokes;
}

void cut_again(PlanStrokes& strokes, const std::vector<std::pair<int, Point>>& edge_and_place) {
  std::unordered_map<std::uint64_t, std::map<double, int>> cuts;  // node by distance from the edge's `from`
  for (const auto& [number, place] : edge_and_place) {
    const PlanEdge& edge = strokes.edges[static_cast<std::size_t>(number)];
    if (cuts[key_of(edge.from, edge.to)]
            .try_emplace((place - strokes.at(edge.from)).norm(), strokes.nodes.size())
            .second)
      strokes.nodes.push_back(place);
  }
  for (PlanPath& path : strokes.paths) {
    std::vector<int> nodes;
    for (std::size_t k = 0; k < path.nodes.size(); ++k) {
      nodes.push_back(path.nodes[k]);
      if (k + 1 == path.nodes.size() && !path.closed) break;
      const int next = path.nodes[(k + 1) % path.nodes.size()];
      const auto found = cuts.find(key_of(path.nodes[k], next));
      if (found == cuts.end()) continue;
      std::vector<int> between;
      for (const auto& [along, node] : found->second) between.push_back(node);
      if (path.nodes[k] > next) std::reverse(between.begin(), between.end());
      nodes.insert(nodes.end(), between.begin(), between.end());
    }
    path.nodes = std::move(nodes);
  }
  collect_edges(strokes);
}

}  // namespace opal
