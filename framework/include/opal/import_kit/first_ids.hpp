#pragma once

#include <cstddef>
#include <string>

namespace opal {

/// "d1, d2, ..." of at most five, for the sentences of a report. @param ids  of any container of texts, in its order.
template <class Texts>
std::string first_of(const Texts& ids) {
  constexpr std::size_t kMost = 5;
  std::string list;
  std::size_t count = 0;
  for (const std::string& id : ids)
    if (count++ < kMost) list += (list.empty() ? "" : ", ") + id;
  return count > kMost ? list + ", ..." : list;
}

}  // namespace opal
