#include "line_mesh.hpp"

#include "point_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace opal::ifc_importer {
namespace {

struct Extent {
  double low_x, high_x, low_y, high_y;
  std::size_t line;
};

std::vector<Extent> extents_by_x(const std::vector<Segment>& lines, double margin) {
  std::vector<Extent> extents;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto [low_x, high_x] = std::minmax(lines[k].begin.x(), lines[k].end.x());
    const auto [low_y, high_y] = std::minmax(lines[k].begin.y(), lines[k].end.y());
    extents.push_back({low_x - margin, high_x + margin, low_y - margin, high_y + margin, k});
  }
  std::ranges::sort(extents, {}, &Extent::low_x);
  return extents;
}

/// Calls visit(a, b) for lines whose boxes meet.
template <class Visit>
void visit_neighbours(const std::vector<Segment>& lines, double margin, Visit visit) {
  const std::vector<Extent> extents = extents_by_x(lines, margin);
  for (std::size_t a = 0; a < extents.size(); ++a)
    for (std::size_t b = a + 1; b < extents.size() && extents[b].low_x <= extents[a].high_x; ++b)
      if (extents[b].low_y <= extents[a].high_y && extents[a].low_y <= extents[b].high_y)
        visit(extents[a].line, extents[b].line);
}

/// Where two lines cross between their ends.
bool crossing(const Segment& a, const Segment& b, Point& at) {
  const Point u = a.end - a.begin, v = b.end - b.begin;
  const double sine = cross(u, v);
  if (std::abs(sine) <= 1e-9 * u.norm() * v.norm()) return false;
  const double s = cross(b.begin - a.begin, v) / sine, t = cross(b.begin - a.begin, u) / sine;
  if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return false;
  at = a.begin + s * u;
  return true;
}

}  // namespace

LineMesh::LineMesh(const std::vector<Segment>& lines, double same_m) {
  PointNodes nodes(same_m);
  std::vector<std::vector<int>> on_line(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k)
    on_line[k] = {nodes.nearest_or_new(lines[k].begin), nodes.nearest_or_new(lines[k].end)};
  const auto divide_at_ends = [&](std::size_t line, std::size_t by) {
    for (std::size_t end = 0; end < 2; ++end) {
      const int node = on_line[by][end];
      if (distance_m(lines[line], nodes.points()[static_cast<std::size_t>(node)]) <= same_m)
        on_line[line].push_back(node);
    }
  };
  visit_neighbours(lines, same_m, [&](std::size_t a, std::size_t b) {
    divide_at_ends(a, b);
    divide_at_ends(b, a);
    Point at = Point::Zero();
    if (!crossing(lines[a], lines[b], at)) return;
    const int node = nodes.nearest_or_new(at);
    on_line[a].push_back(node);
    on_line[b].push_back(node);
  });
  std::map<std::pair<int, int>, std::size_t> numbers;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Point along = lines[k].end - lines[k].begin;
    const auto position = [&](int node) { return along.dot(nodes.points()[static_cast<std::size_t>(node)]); };
    std::vector<int>& chain = on_line[k];
    std::stable_sort(chain.begin(), chain.end(), [&](int a, int b) { return position(a) < position(b); });
    chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
    for (std::size_t i = 1; i < chain.size(); ++i) add(numbers, chain[i - 1], chain[i], static_cast<int>(k));
  }
  nodes_ = nodes.points();
}

void LineMesh::add(std::map<std::pair<int, int>, std::size_t>& numbers, int from, int to, int line) {
  const auto [entry, is_new] = numbers.try_emplace(std::minmax(from, to), edges_.size());
  if (is_new) edges_.push_back({from, to});
  Edge& edge = edges_[entry->second];
  (edge.from == from ? edge.along : edge.against).push_back(line);
}

std::vector<std::vector<std::size_t>> closed_chains(const LineMesh& mesh, const std::vector<LineMesh::Edge>& directed) {
  std::map<int, std::vector<std::size_t>> leaving;
  for (std::size_t k = 0; k < directed.size(); ++k) leaving[directed[k].from].push_back(k);
  std::vector<bool> used(directed.size());
  const auto heading = [&](std::size_t k) { return mesh.segment(directed[k]).heading_rad(); };
  const auto next_of = [&](std::size_t k) {
    std::size_t best = directed.size();
    double best_turn = -4;
    for (const std::size_t next : leaving[directed[k].to]) {
      const double turn = wrap_angle(heading(next) - heading(k));
      if (!used[next] && turn > best_turn) best = next, best_turn = turn;
    }
    return best;
  };
  std::vector<std::vector<std::size_t>> chains;
  for (std::size_t first = 0; first < directed.size(); ++first) {
    if (used[first]) continue;
    std::vector<std::size_t> chain;
    std::size_t k = first;
    while (k < directed.size()) {
      used[k] = true;
      chain.push_back(k);
      if (directed[k].to == directed[first].from) break;
      k = next_of(k);
    }
    if (k < directed.size() && chain.size() >= 3) chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace opal::ifc_importer
