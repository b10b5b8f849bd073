#pragma once

#include <string>

namespace opal::postgis_store {

/// The text on one line, without passwords: neither PGPASSWORD's, nor one in a connection string that a server repeats.
std::string without_secrets(std::string text);

}  // namespace opal::postgis_store
