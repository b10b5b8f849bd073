#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

/// The value below which a share of all lie; 0 if there is none. @param sorted  increasing.
inline double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))];
}
