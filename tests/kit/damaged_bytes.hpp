#pragma once

#include <random>
#include <string>
#include <vector>

namespace opal {

/// The bytes of a file of more than 4096 bytes, cut at several places, and with a page more.
inline std::vector<std::string> cut_or_grown(const std::string& whole) {
  std::vector<std::string> others{whole + std::string(4096, '\0')};
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{100}, std::size_t{4096}, whole.size() / 2,
                                 whole.size() - 4096, whole.size() - 1})
    others.push_back(whole.substr(0, size));
  return others;
}

/// The bytes of a file with three wrong ones, so many times. Half of them have these in the header.
inline std::vector<std::string> with_wrong_bytes(const std::string& whole, std::size_t times) {
  std::mt19937 random(5);
  std::vector<std::string> others(times, whole);
  for (std::size_t k = 0; k < times; ++k)
    for (int change = 0; change < 3; ++change)
      others[k][random() % (k % 2 == 0 ? 200 : whole.size())] = static_cast<char>(random());
  return others;
}

}  // namespace opal
