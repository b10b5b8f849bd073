#pragma once

#include "patterns/pattern_index.hpp"

#include <opal/common/named.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/patterns/pattern_template.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace opal {

/// What members of mapped patterns stand for: each for one feature of the map, or for faces along a line.
class MemberNumbers {
 public:
  void add(std::span<const MapFeatureNumber> numbers) {
    numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
    ends_.push_back(static_cast<std::uint32_t>(numbers_.size()));
  }
  /// Nothing will be added.
  void shrink_to_fit() {
    numbers_.shrink_to_fit();
    ends_.shrink_to_fit();
  }
  /// Of the member that was added after so many others.
  std::span<const MapFeatureNumber> operator[](int member) const {
    const std::uint32_t begin = member == 0 ? 0 : ends_[member - 1];
    return {&numbers_[begin], ends_[member] - begin};
  }

 private:
  std::vector<MapFeatureNumber> numbers_;
  std::vector<std::uint32_t> ends_;
};

/// The map's side of all patterns. The map decides: what its pattern layer names if it has one, else all there are
/// among its features and support lines.
struct MappedPatterns {
  MemberNumbers members;
  /// For each template its patterns.
  std::vector<PatternIndex> by_template;
};

/// @throws MapError if the layer contradicts its templates.
MappedPatterns mapped_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates);

}  // namespace opal
