#include "patterns/pattern_layer.hpp"

#include "patterns/sound_instance.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace opal {
namespace {

constexpr std::array<const char*, 4> kShapes{"a point", "a corner", "a segment", "a circle"};

std::string number_text(double value) { return fmt::format("{:.3f}", value); }

/// A pattern of the layer, held against its template.
class LayerPattern {
 public:
  LayerPattern(const MapView& map, const MapPattern& pattern, const PatternTemplate& pattern_template)
      : map_(map), pattern_(pattern), template_(pattern_template), shape_(pattern_template.shape()) {}

  PatternInstance instance() {
    check_shapes();
    for (const MapFeatureNumber number : pattern_.features)
      members_.push_back({map_.feature(number).type, map_.feature(number).geometry});
    std::vector<int> order(members_.size());
    std::iota(order.begin(), order.end(), 0);
    PatternInstance found = in_order(order);
    check_dimensions(found);
    for (int& member : found.members) member = position_of(pattern_.features[member]);
    return found;
  }

 private:
  [[noreturn]] void fail(const std::string& complaint) const {
    throw MapError(pattern_.place + ": pattern '" + pattern_.id + "' of " + pattern_.pattern_template + " " +
                   complaint);
  }
  const std::string& id(int member) const { return map_.feature(pattern_.features[member]).id; }

  /// Among the perceivable features, which are in order.
  int position_of(MapFeatureNumber number) const {
    const auto all = map_.features();
    return static_cast<int>(std::lower_bound(all.begin(), all.end(), number) - all.begin());
  }

  void check_shapes() const {
    if (pattern_.features.size() != shape_.slots.size())
      fail("has " + std::to_string(pattern_.features.size()) + " features, expected " +
           std::to_string(shape_.slots.size()));
    for (std::size_t k = 0; k < shape_.slots.size(); ++k) {
      const GeometryKind kind = kind_of(map_.feature(pattern_.features[k]).geometry);
      if (kind != shape_.slots[k])
        fail("has the member '" + id(static_cast<int>(k)) + "', which is " + kShapes[static_cast<std::size_t>(kind)] +
             ", expected " + kShapes[static_cast<std::size_t>(shape_.slots[k])]);
    }
  }

  std::optional<PatternInstance> match(const std::vector<int>& order) const {
    std::vector<const Feature*> offered;
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
      offered.push_back(&members_[order[slot]]);
      if (kind_of(offered.back()->geometry) != shape_.slots[slot]) return std::nullopt;
    }
    auto instance = template_.match(offered);
    if (!instance) return std::nullopt;
    expect_sound(*instance, order.size());
    for (int& member : instance->members) member = order[member];
    return instance;
  }

  /// In the order of the map; symmetric patterns in any.
  PatternInstance in_order(const std::vector<int>& as_written) const {
    if (auto instance = match(as_written)) return std::move(*instance);
    for (std::vector<int> order = as_written; std::next_permutation(order.begin(), order.end());)
      if (auto instance = match(order)) {
        if (instance->symmetric) return std::move(*instance);
        std::string expected;
        for (const int member : order) expected += (expected.empty() ? "'" : ", '") + id(member) + "'";
        fail("has its features in another order, expected " + expected);
      }
    fail("has features that do not stand to each other as the template asks");
  }

  void check_dimensions(const PatternInstance& found) const {
    const std::vector<double>& given = pattern_.dimensions;
    if (given.size() > found.invariants.size())
      fail("has " + std::to_string(given.size()) + " dimensions, expected at most " +
           std::to_string(found.invariants.size()));
    for (std::size_t k = 0; k < given.size(); ++k)
      if (std::abs(given[k] - found.invariants[k].value) > found.invariants[k].tolerance + 1e-9)
        fail("has the dimension " + number_text(given[k]) + " at position " + std::to_string(k) +
             ", but its features give " + number_text(found.invariants[k].value));
  }

  const MapView& map_;
  const MapPattern& pattern_;
  const PatternTemplate& template_;
  const PatternShape shape_;
  std::vector<Feature> members_;
};

}  // namespace

bool is_for_sensor(const MapView& map, const MapPattern& pattern) {
  return map.feature(pattern.features.front()).sensor == map.feature(map.features().front()).sensor;
}

std::vector<PatternInstance> layer_instances(const MapView& map, const std::string& name,
                                             const PatternTemplate& pattern_template) {
  std::vector<PatternInstance> instances;
  for (const MapPattern& pattern : map.map().patterns())
    if (pattern.pattern_template == name && is_for_sensor(map, pattern))
      instances.push_back(LayerPattern(map, pattern, pattern_template).instance());
  return instances;
}

bool has_pattern_layer(const MapView& map) {
  const auto& all = map.map().patterns();
  return std::any_of(all.begin(), all.end(), [&](const MapPattern& pattern) { return is_for_sensor(map, pattern); });
}

}  // namespace opal
