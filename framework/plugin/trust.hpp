#pragma once

#include <opal/plugin/trusted_plugins.hpp>

#include <string>

namespace opal {

/// By which a file of classes is known in a list.
std::string class_file_key(const std::string& file);

/// Whether a plugin's library is what a list says. @throws ConfigError naming plugin, file, and both digests.
/// @param digest  SHA-256 of the file.
void expect_trusted_plugin(const TrustedPlugins& trusted, const std::string& plugin, const std::string& file,
                           const std::string& digest);

/// Whether the file of a class is. @param source  "FILE:CLASS", found. @throws ConfigError likewise, also for a class
/// that is in no file but in a module.
void expect_trusted_class(const TrustedPlugins& trusted, const std::string& source);

}  // namespace opal
