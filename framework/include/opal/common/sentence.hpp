#pragma once

#include <opal/common/export.hpp>

#include <string>

namespace opal {

/// Like printf, as a string of any length.
[[gnu::format(printf, 1, 2)]] OPAL_EXPORT std::string sentence(const char* pattern, ...);

}  // namespace opal
