#pragma once

#include <opal/common/export.hpp>

#include <map>
#include <string>

namespace opal {

/// A file as somebody has seen it.
struct TrustedFile {
  std::string sha256;  ///< of the file: 64 hexadecimal digits, lower case
  std::string where;   ///< file and JSON pointer of the digest, for messages
  /// True if all of it is the same.
  bool operator==(const TrustedFile&) const = default;
};

/// The files whose code may run, and no others: "trusted_plugins" of a deployment.
struct TrustedPlugins {
  std::string where;                                ///< file and JSON pointer of the list, for messages
  std::map<std::string, TrustedFile> plugins;       ///< shared libraries, by the name of the plugin
  std::map<std::string, TrustedFile> class_files;   ///< files of classes ("acme.py"), by their canonical path
  std::map<std::string, TrustedFile> descriptions;  ///< those beside the libraries, likewise; without: any will do
  /// True if all of it is the same.
  bool operator==(const TrustedPlugins&) const = default;
};

}  // namespace opal
