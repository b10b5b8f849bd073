#include "patterns/pattern_table.hpp"

namespace opal {

PatternTable::PatternTable(std::span<const PatternInstance> patterns) {
  for (const PatternInstance& pattern : patterns) add(pattern);
}

void PatternTable::add(const PatternInstance& pattern) {
  if (frames_.empty()) {
    dimensions_ = pattern.invariants.size();
    slots_ = pattern.members.size();
  }
  const bool is_extended = pattern.extent_min_m != 0 || pattern.extent_max_m != 0;
  if (is_extended && extents_m_.empty()) extents_m_.resize(frames_.size());
  if (is_extended || !extents_m_.empty()) extents_m_.push_back({pattern.extent_min_m, pattern.extent_max_m});
  frames_.push_back({pattern.frame.x(), pattern.frame.y(), pattern.frame.heading_rad()});
  members_.insert(members_.end(), pattern.members.begin(), pattern.members.end());
  for (const Invariant& invariant : pattern.invariants) values_.push_back(static_cast<float>(invariant.value));
}

void PatternTable::shrink_to_fit() {
  frames_.shrink_to_fit();
  members_.shrink_to_fit();
  extents_m_.shrink_to_fit();
}

}  // namespace opal
