#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace opal {

/// The middle value, of an even number the upper one of the two; none if there are no values.
inline std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace opal
