#pragma once

#include <string>

namespace opal::ifc_importer {

/// Like printf, as a string of any length.
[[gnu::format(printf, 1, 2)]] std::string sentence(const char* pattern, ...);

}  // namespace opal::ifc_importer
