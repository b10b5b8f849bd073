#include "patterns/pattern_index.hpp"

#include "common/geometry_box.hpp"
#include "patterns/sound_instance.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>

namespace opal {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<BoostPoint>;
using Entry = std::pair<Box, int>;

Box box_around(const Geometry& geometry) {
  const Eigen::AlignedBox2d box = box_of(geometry);
  return {{box.min().x(), box.min().y()}, {box.max().x(), box.max().y()}};
}

bool crosses(const Segment& a, const Segment& b) {
  const Point u = a.end - a.begin, v = b.end - b.begin;
  const double d = cross(u, v);
  if (d == 0) return false;
  const double s = cross(b.begin - a.begin, v) / d, t = cross(b.begin - a.begin, u) / d;
  return s >= 0 && s <= 1 && t >= 0 && t <= 1;
}

/// Whether two geometries are no farther apart than this; circles count as their centres, less the radius.
bool within(double reach_m, const Geometry& a, const Geometry& b) {
  const auto* segment_a = std::get_if<Segment>(&a);
  const auto* segment_b = std::get_if<Segment>(&b);
  if (segment_a && segment_b)
    return distance_m(*segment_a, segment_b->begin) <= reach_m || distance_m(*segment_a, segment_b->end) <= reach_m ||
           distance_m(*segment_b, segment_a->begin) <= reach_m || distance_m(*segment_b, segment_a->end) <= reach_m ||
           crosses(*segment_a, *segment_b);
  return segment_b ? within(reach_m, b, a) : distance_m(a, anchor_of(b)) <= reach_m;
}

/// Fills the slots of a template one by one with features near all earlier ones.
class Enumeration {
 public:
  using Visit = std::function<void(PatternInstance&&)>;
  Enumeration(const PatternTemplate& pattern_template, std::span<const Feature> features, const Visit& visit)
      : template_(pattern_template), shape_(pattern_template.shape()), features_(features), visit_(visit) {
    std::array<std::vector<Entry>, kKinds> entries;
    for (std::size_t k = 0; k < features.size(); ++k)
      entries[features[k].geometry.index()].emplace_back(box_around(features[k].geometry), static_cast<int>(k));
    for (std::size_t kind = 0; kind < kKinds; ++kind) trees_[kind] = Tree(entries[kind]);
  }

  void run() {
    for (std::size_t k = 0; k < features_.size() && !shape_.slots.empty(); ++k) fill(static_cast<int>(k));
  }

 private:
  static constexpr std::size_t kKinds = std::variant_size_v<Geometry>;
  using Tree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

  void fill(int candidate) {
    if (kind_of(features_[candidate].geometry) != shape_.slots[chosen_.size()]) return;
    for (int earlier : chosen_)
      if (earlier == candidate ||
          !are_within(earlier == chosen_.back() ? neighbour_m_ : shape_.reach_m, earlier, candidate))
        return;
    chosen_.push_back(candidate);
    if (chosen_.size() == shape_.slots.size())
      offer();
    else
      for (int next : around(chosen_.back(), neighbour_m_, shape_.slots[chosen_.size()])) fill(next);
    chosen_.pop_back();
  }

  bool are_within(double reach_m, int a, int b) const {
    return within(reach_m, features_[a].geometry, features_[b].geometry);
  }

  /// Of one kind, by number.
  std::vector<int> around(int number, double r, GeometryKind kind) const {
    Box box = box_around(features_[number].geometry);
    box = {{box.min_corner().get<0>() - r, box.min_corner().get<1>() - r},
           {box.max_corner().get<0>() + r, box.max_corner().get<1>() + r}};
    std::vector<int> numbers;
    trees_[static_cast<std::size_t>(kind)].query(
        bg::index::intersects(box),
        boost::make_function_output_iterator([&](const Entry& entry) { numbers.push_back(entry.second); }));
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }

  void offer() {
    offered_.clear();
    for (int number : chosen_) offered_.push_back(&features_[number]);
    auto instance = template_.match(offered_);
    if (!instance) return;
    expect_sound(*instance, chosen_.size());
    for (int& member : instance->members) member = chosen_[member];
    visit_(std::move(*instance));
  }

  const PatternTemplate& template_;
  const PatternShape shape_;
  const double neighbour_m_ = shape_.neighbour_reach_m > 0 ? shape_.neighbour_reach_m : shape_.reach_m;
  std::span<const Feature> features_;
  const Visit& visit_;
  std::array<Tree, kKinds> trees_;  ///< of the features of each kind
  std::vector<int> chosen_;
  std::vector<const Feature*> offered_;
};

}  // namespace

std::vector<PatternInstance> find_patterns(const PatternTemplate& pattern_template, std::span<const Feature> features) {
  std::vector<PatternInstance> found;
  each_pattern(pattern_template, features, [&](PatternInstance&& pattern) { found.push_back(std::move(pattern)); });
  return found;
}

void each_pattern(const PatternTemplate& pattern_template, std::span<const Feature> features,
                  const std::function<void(PatternInstance&&)>& visit) {
  Enumeration(pattern_template, features, visit).run();
}

}  // namespace opal
