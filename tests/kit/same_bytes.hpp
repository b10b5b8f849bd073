#pragma once
#include <algorithm>
#include <span>

#include "common/prepared/read_only_array.hpp"

namespace opal {

/// Whether two arrays have the same bytes; NaN is the same as NaN.
template <class T>
bool same_bytes(const ReadOnlyArray<T>& a, const ReadOnlyArray<T>& b) {
  return std::ranges::equal(std::as_bytes(a.values()), std::as_bytes(b.values()));
}

}  // namespace opal
