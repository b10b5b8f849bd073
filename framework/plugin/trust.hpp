#pragma once

#include <opal/plugin/trusted_plugins.hpp>

#include <string>

namespace opal {

class DescribedLibrary;

/// By which a file of classes is known in a list.
std::string class_file_key(const std::string& file);

/// Whether a plugin's library, and its description if the list has that, are what the list says. @throws ConfigError
/// naming plugin, file, and both digests.
void expect_trusted_plugin(const TrustedPlugins& trusted, DescribedLibrary& library);

/// Whether the file of a class is. @param source  "FILE:CLASS", found. @throws ConfigError likewise, also for a class
/// that is in no file but in a module.
void expect_trusted_class(const TrustedPlugins& trusted, const std::string& source);

}  // namespace opal
