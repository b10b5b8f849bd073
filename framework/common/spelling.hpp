#pragma once

#include <opal/common/export.hpp>

#include <cstddef>
#include <string>

namespace opal {

/// How many letters must be put in, left out or changed (Levenshtein 1966).
OPAL_EXPORT std::size_t letters_between(const std::string& a, const std::string& b);

/// Near enough for a slip: two letters, and fewer than half. Of a short word nearly everything is near.
OPAL_EXPORT bool is_misspelt(const std::string& word, const std::string& meant);

}  // namespace opal
