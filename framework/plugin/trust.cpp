#include "plugin/trust.hpp"

#include "common/digest/sha256.hpp"
#include "common/phrases.hpp"
#include "plugin/class_source.hpp"
#include "plugin/described_library.hpp"

#include <opal/common/error.hpp>

#include <filesystem>
#include <vector>

namespace opal {
namespace {

namespace fs = std::filesystem;

/// @param found  a sentence about the file.
void expect_digest(const TrustedFile& expected, const std::string& digest, const std::string& found) {
  if (digest != expected.sha256)
    throw ConfigError(expected.where + ": " + found + ", expected " + expected.sha256 +
                      ": it is not the file that is trusted");
}

std::string digest_found(const std::string& what, const std::string& file, const std::string& digest) {
  return what + ": " + file + " has SHA-256 " + digest;
}

/// @param known  what the list names of this sort.
void expect_listed(const TrustedPlugins& trusted, const std::map<std::string, TrustedFile>& known,
                   const std::string& key, const std::string& what, const std::string& file,
                   const std::string& digest) {
  const std::string found = digest_found(what, file, digest);
  const auto listed_file = known.find(key);
  if (listed_file == known.end()) {
    std::vector<std::string> names;
    for (const auto& [name, ignored] : known) names.push_back(name);
    throw ConfigError(trusted.where + ": " + found +
                      " and is not in the list, expected one of: " + listed(names, "none"));
  }
  expect_digest(listed_file->second, digest, found);
}

}  // namespace

std::string class_file_key(const std::string& file) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(file), error);
  return error ? file : canonical.string();
}

void expect_trusted_plugin(const TrustedPlugins& trusted, DescribedLibrary& library) {
  const PluginDescription& description = library.description();
  const std::string what = "plugin " + description.name;
  expect_listed(trusted, trusted.plugins, description.name, what, library.file(), library.digest());
  const auto expected = trusted.descriptions.find(description.name);
  if (expected == trusted.descriptions.end()) return;
  expect_digest(expected->second, description.sha256,
                digest_found(what, description_file(library.file()), description.sha256));
}

void expect_trusted_class(const TrustedPlugins& trusted, const std::string& source) {
  const auto found = read_class_source(source);
  if (!found)
    throw ConfigError(trusted.where + ": " + source +
                      " is a class of a module, expected FILE.py:CLASS with the file in the list");
  expect_listed(trusted, trusted.class_files, class_file_key(found->file), "class " + found->name, found->file,
                sha256_of_file(found->file));
}

}  // namespace opal
