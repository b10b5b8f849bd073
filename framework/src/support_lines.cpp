#include "support_lines.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>

namespace opal {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<BoostPoint>;
using Entry = std::pair<Box, std::size_t>;
using RTree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

struct Line {
  Segment extent;
  double support_m = 0;
  std::vector<int> numbers;
};

/// Where `face` begins and ends along `line`, and how far aside of it, all [m].
struct Relation {
  double begin, end, aside_begin, aside_end;
};

Relation relate(const Segment& line, const Segment& face) {
  const Point u = line.direction(), n = line.normal();
  return {u.dot(face.begin - line.begin), u.dot(face.end - line.begin), n.dot(face.begin - line.begin),
          n.dot(face.end - line.begin)};
}

bool collinear(const Segment& line, const Segment& face, const SupportLineOptions& options) {
  // The heading of a short face is known only to a few centimetres over its length.
  const double angle = std::max(options.angle_rad, std::min(0.35, 0.04 / face.length_m()));
  if (std::abs(wrap_angle(line.heading_rad() - face.heading_rad())) > angle) return false;
  const Relation r = relate(line, face);
  return std::abs(r.aside_begin) <= options.offset_m && std::abs(r.aside_end) <= options.offset_m &&
         r.begin <= line.length_m() + options.gap_m && r.end >= -options.gap_m;
}

void absorb(Line& line, const Line& face) {
  const Relation r = relate(line.extent, face.extent);
  const double weight = face.support_m / (line.support_m + face.support_m);
  const Point shift = line.extent.normal() * (weight * (r.aside_begin + r.aside_end) / 2);
  const Point u = line.extent.direction(), origin = line.extent.begin;
  const double from = std::min(0.0, r.begin), to = std::max(line.extent.length_m(), r.end);
  line.extent = {origin + from * u + shift, origin + to * u + shift};
  line.support_m = std::min(to - from, line.support_m + face.support_m);
  line.numbers.insert(line.numbers.end(), face.numbers.begin(), face.numbers.end());
}

Box box_around(const Segment& segment, double margin_m) {
  const Point low = segment.begin.cwiseMin(segment.end), high = segment.begin.cwiseMax(segment.end);
  return {{low.x() - margin_m, low.y() - margin_m}, {high.x() + margin_m, high.y() + margin_m}};
}

/// The first line after number `after`, of those that are left, that goes on in line number `a`; lines.size() if none.
std::size_t next_collinear(const RTree& tree, const std::vector<Line>& lines, const std::vector<bool>& gone,
                           std::size_t a, std::size_t after, const SupportLineOptions& options) {
  std::size_t first = lines.size();
  const Box box = box_around(lines[a].extent, options.gap_m + options.offset_m + 0.01);
  for (auto it = tree.qbegin(bg::index::intersects(box)); it != tree.qend(); ++it) {
    const std::size_t b = it->second;
    if (b > after && b < first && !gone[b] && collinear(lines[a].extent, lines[b].extent, options)) first = b;
  }
  return first;
}

/// One pass: longer lines absorb shorter ones. True if any was absorbed.
bool absorb_once(std::vector<Line>& lines, const SupportLineOptions& options) {
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return a.support_m > b.support_m; });
  std::vector<Entry> entries;
  for (std::size_t k = 0; k < lines.size(); ++k) entries.emplace_back(box_around(lines[k].extent, 0), k);
  const RTree tree(entries);
  std::vector<bool> gone(lines.size(), false);
  bool any = false;
  for (std::size_t a = 0; a < lines.size(); ++a) {
    if (gone[a]) continue;
    for (std::size_t b = a; (b = next_collinear(tree, lines, gone, a, b, options)) < lines.size();) {
      absorb(lines[a], lines[b]);
      gone[b] = any = true;
    }
  }
  std::vector<Line> kept;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (!gone[k]) kept.push_back(std::move(lines[k]));
  lines = std::move(kept);
  return any;
}

}  // namespace

std::vector<MappedFeature> support_lines(const SemanticMap& map, std::vector<int> faces,
                                         const SupportLineOptions& options) {
  std::sort(faces.begin(), faces.end());
  std::vector<Line> lines;
  for (int number : faces) {
    const auto& face = std::get<Segment>(map.features()[number].geometry);
    if (face.length_m() >= options.min_length_m) lines.push_back({face, face.length_m(), {number}});
  }
  while (absorb_once(lines, options)) {
  }
  std::vector<MappedFeature> found;
  for (Line& line : lines) {
    MappedFeature mapped;
    mapped.feature.type = map.features()[line.numbers.front()].type;
    mapped.feature.geometry = line.extent;
    mapped.feature.support_m = line.support_m;
    mapped.numbers = std::move(line.numbers);
    found.push_back(std::move(mapped));
  }
  return found;
}

std::vector<MappedFeature> mapped_features(const SemanticMap& map, std::span<const int> perceivable) {
  std::vector<int> faces;
  std::vector<MappedFeature> all;
  for (int number : perceivable) {
    const MapFeature& feature = map.features()[number];
    if (kind_of(feature.geometry) == GeometryKind::segment) {
      faces.push_back(number);
      continue;
    }
    MappedFeature mapped;
    mapped.feature.type = feature.type;
    mapped.feature.geometry = feature.geometry;
    mapped.numbers = {number};
    all.push_back(std::move(mapped));
  }
  for (MappedFeature& line : support_lines(map, std::move(faces), {})) all.push_back(std::move(line));
  return all;
}

}  // namespace opal
