#include "map/view/support_lines.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <functional>
#include <optional>

namespace opal {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using FaceBox = bg::model::box<BoostPoint>;
using NumberedBox = std::pair<FaceBox, std::size_t>;
using FaceTree = bg::index::rtree<NumberedBox, bg::index::quadratic<16>>;

struct Line {
  Segment extent;
  double support_m = 0;
  std::vector<MapFeatureNumber> numbers;
  bool is_new = true;  ///< has grown in the pass before, or there was none
};

/// Where `face` begins and ends along `line`, and how far aside of it, all [m].
struct Relation {
  double begin, end, aside_begin, aside_end;
};

/// A line to which many faces are related.
class LineFrame {
 public:
  explicit LineFrame(const Segment& line) : begin_(line.begin), u_(line.direction()), n_(line.normal()) {}

  Relation of(const Segment& face) const {
    const Point to_begin = face.begin - begin_, to_end = face.end - begin_;
    return {u_.dot(to_begin), u_.dot(to_end), n_.dot(to_begin), n_.dot(to_end)};
  }

 private:
  Point begin_, u_, n_;
};

Relation relate(const Segment& line, const Segment& face) { return LineFrame(line).of(face); }

/// A line that asks many faces whether they go on in it.
class Asking {
 public:
  Asking(const Segment& line, const SupportLineOptions& options)
      : options_(options), frame_(line), length_m_(line.length_m()), heading_rad_(line.heading_rad()) {}

  bool collinear(const Segment& face) const { return goes_on_in(face) && same_heading(face); }

 private:
  bool goes_on_in(const Segment& face) const {
    const Relation r = frame_.of(face);
    return std::abs(r.aside_begin) <= options_.offset_m && std::abs(r.aside_end) <= options_.offset_m &&
           r.begin <= length_m_ + options_.gap_m && r.end >= -options_.gap_m;
  }

  bool same_heading(const Segment& face) const {
    // The heading of a short face is known only to a few centimetres over its length.
    const double angle = std::max(options_.angle_rad, std::min(0.35, 0.04 / face.length_m()));
    return std::abs(wrap_angle(heading_rad_ - face.heading_rad())) <= angle;
  }

  const SupportLineOptions& options_;
  LineFrame frame_;
  double length_m_, heading_rad_;
};

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

FaceBox box_around(const Segment& segment, double margin_m) {
  const Point low = segment.begin.cwiseMin(segment.end), high = segment.begin.cwiseMax(segment.end);
  return {{low.x() - margin_m, low.y() - margin_m}, {high.x() + margin_m, high.y() + margin_m}};
}

Segment prolonged(const Segment& line, double by_m) {
  const Point further = by_m * line.direction();
  return {line.begin - further, line.end + further};
}

/// What may go on in a line that grows. Looked up along the line for more than its reach, so that it can grow for a
/// while.
class Continuations {
 public:
  Continuations(const FaceTree& tree, const SupportLineOptions& options) : tree_(tree), options_(options) {}

  /// Numbers of all lines that may go on in `line`, ascending.
  const std::vector<std::size_t>& of(const Segment& line) {
    if (!looked_along_ || !covers(line)) look_along(prolonged(line, options_.gap_m + kFurther_m));
    return numbers_;
  }

 private:
  static constexpr double kFurther_m = 30, kAside_m = 0.1, kStep_m = 20, kMostSteps = 1000;

  bool covers(const Segment& line) const {
    const Relation r = relate(*looked_along_, prolonged(line, options_.gap_m));
    return r.begin >= 0 && r.end <= looked_along_->length_m() && std::abs(r.aside_begin) <= kAside_m &&
           std::abs(r.aside_end) <= kAside_m;
  }

  /// In steps, because the box around a long line that lies aslant holds half of a map.
  void look_along(const Segment& line) {
    looked_along_ = line;
    numbers_.clear();
    const int steps = 1 + static_cast<int>(std::min(line.length_m() / kStep_m, kMostSteps));
    const Point step = (line.end - line.begin) / steps;
    for (int k = 0; k < steps; ++k) {
      const Segment piece{line.begin + k * step, line.begin + (k + 1) * step};
      const FaceBox box = box_around(piece, options_.offset_m + kAside_m + 0.01);
      for (auto it = tree_.qbegin(bg::index::intersects(box)); it != tree_.qend(); ++it) numbers_.push_back(it->second);
    }
    std::sort(numbers_.begin(), numbers_.end());
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  }

  const FaceTree& tree_;
  const SupportLineOptions& options_;
  std::optional<Segment> looked_along_;
  std::vector<std::size_t> numbers_;
};

/// The first line after number `after`, of those that are left, that goes on in `line`; lines.size() if none.
std::size_t next_collinear(const Segment& line, const std::vector<std::size_t>& continuations,
                           const std::vector<Line>& lines, const std::vector<bool>& gone, std::size_t after,
                           const SupportLineOptions& options) {
  const Asking asking(line, options);
  for (auto b = std::upper_bound(continuations.begin(), continuations.end(), after); b != continuations.end(); ++b)
    if (!gone[*b] && asking.collinear(lines[*b].extent)) return *b;
  return lines.size();
}

/// The boxes of lines, or of those that are new.
FaceTree tree_of(const std::vector<Line>& lines, bool only_new) {
  std::vector<NumberedBox> entries;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].is_new || !only_new) entries.emplace_back(box_around(lines[k].extent, 0), k);
  return FaceTree(entries);
}

/// One pass: longer lines absorb shorter ones. Two lines of which neither is new did not go on in each other in the
/// pass before. True if any was absorbed.
bool absorb_once(std::vector<Line>& lines, const SupportLineOptions& options) {
  std::ranges::stable_sort(lines, std::greater{}, &Line::support_m);
  const FaceTree all = tree_of(lines, false), fresh = tree_of(lines, true);
  std::vector<bool> gone(lines.size(), false), grown(lines.size(), false);
  bool any = false;
  for (std::size_t a = 0; a < lines.size(); ++a) {
    if (gone[a]) continue;
    Continuations among_all(all, options), among_fresh(fresh, options);
    const Segment& line = lines[a].extent;
    for (std::size_t b = a;;) {
      Continuations& continuations = lines[a].is_new || grown[a] ? among_all : among_fresh;
      b = next_collinear(line, continuations.of(line), lines, gone, b, options);
      if (b == lines.size()) break;
      absorb(lines[a], lines[b]);
      gone[b] = grown[a] = any = true;
    }
  }
  std::vector<Line> kept;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    lines[k].is_new = grown[k];
    if (!gone[k]) kept.push_back(std::move(lines[k]));
  }
  lines = std::move(kept);
  return any;
}

}  // namespace

std::vector<MappedFeature> support_lines(const SemanticMap& map, std::vector<MapFeatureNumber> faces,
                                         const SupportLineOptions& options) {
  std::sort(faces.begin(), faces.end());
  std::vector<Line> lines;
  for (MapFeatureNumber number : faces) {
    const auto& face = std::get<Segment>(map.feature(number).geometry);
    if (face.length_m() >= options.min_length_m) lines.push_back({face, face.length_m(), {number}});
  }
  while (absorb_once(lines, options)) {
  }
  std::vector<MappedFeature> found;
  for (Line& line : lines) {
    MappedFeature mapped;
    mapped.feature.type = map.feature(line.numbers.front()).type;
    mapped.feature.geometry = line.extent;
    mapped.feature.support_m = line.support_m;
    mapped.numbers = std::move(line.numbers);
    found.push_back(std::move(mapped));
  }
  return found;
}

std::vector<MappedFeature> mapped_features(const SemanticMap& map, std::span<const MapFeatureNumber> perceivable) {
  std::vector<MapFeatureNumber> faces;
  std::vector<MappedFeature> all;
  for (MapFeatureNumber number : perceivable) {
    const MapFeature& feature = map.feature(number);
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
