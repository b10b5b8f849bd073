#include "patterns/pattern_table.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

namespace opal {
namespace {

void expect_alike(const char* what, std::size_t found, std::size_t expected) {
  if (found != expected)
    throw PluginError(
        fmt::format("a pattern has {} {}, expected {}, as the first one of its template", found, what, expected));
}

}  // namespace

PatternList::PatternList(std::span<const PatternInstance> patterns) {
  for (const PatternInstance& pattern : patterns) add(pattern);
}

void PatternList::add(const PatternInstance& pattern) {
  if (frames_.empty()) {
    dimensions_ = pattern.invariants.size();
    slots_ = pattern.members.size();
  }
  expect_alike("invariants", pattern.invariants.size(), dimensions_);
  expect_alike("members", pattern.members.size(), slots_);
  const bool is_extended = pattern.extent_min_m != 0 || pattern.extent_max_m != 0;
  if (is_extended && extents_m_.empty()) extents_m_.resize(frames_.size());
  if (is_extended || !extents_m_.empty()) extents_m_.push_back({pattern.extent_min_m, pattern.extent_max_m});
  frames_.push_back({pattern.frame.x(), pattern.frame.y(), pattern.frame.heading_rad()});
  members_.insert(members_.end(), pattern.members.begin(), pattern.members.end());
  for (const Invariant& invariant : pattern.invariants) values_.push_back(static_cast<float>(invariant.value));
}

namespace {

template <class T>
ReadOnlyArray<T> column(std::vector<T>& values) {
  values.shrink_to_fit();
  return ReadOnlyArray<T>(std::move(values));
}

}  // namespace

PatternTable::PatternTable(PatternList patterns)
    : columns_{patterns.slots_, column(patterns.frames_), column(patterns.members_), column(patterns.extents_m_)} {}

}  // namespace opal
