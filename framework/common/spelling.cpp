#include "common/spelling.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace opal {

std::size_t letters_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

bool is_misspelt(const std::string& word, const std::string& meant) {
  constexpr std::size_t kMostLetters = 2;
  const std::size_t letters = letters_between(word, meant);
  return letters > 0 && letters <= kMostLetters && 2 * letters < meant.size();
}

}  // namespace opal
