#include "benchmark/bundle/bundle.hpp"

#include "common/digest/sha256.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "common/json/config_object.hpp"
#include "common/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

namespace opal::ab {
namespace {

namespace fs = std::filesystem;

/// A name that leads nowhere but below the bundle.
void expect_inside(const std::string& name, const ConfigObject& object) {
  const fs::path path(name);
  const bool leaves = path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
  if (name.empty() || leaves) object.refuse("name", "a path below the bundle's folder");
}

BundledFile read_file(ConfigObject object) {
  BundledFile file;
  file.name = object.required_text("name");
  expect_inside(file.name, object);
  file.sha256 = object.required_text("sha256");
  file.bytes = static_cast<std::uint64_t>(object.number("bytes", 0, {0, 1e15}));
  file.included = object.boolean("included", true);
  object.expect_no_more();
  return file;
}

/// What is the matter with a file at some path; empty: it is the one that is meant.
std::string trouble_with(const std::string& path, const BundledFile& file) {
  if (!fs::is_regular_file(path)) return "is not there";
  const std::string sha256 = sha256_of_file(path);
  if (sha256 == file.sha256) return "";
  return "has SHA-256 " + sha256 + ", expected " + file.sha256 + ": it was changed since the bundle was made";
}

/// Files in a folder of the bundle that its list does not have would take part all the same.
void expect_all_listed(const Bundle& bundle) {
  std::set<std::string> listed;
  for (const BundledFile& file : bundle.files)
    if (file.included) listed.insert(file.name);
  for (const auto& entry : fs::recursive_directory_iterator(bundle.folder)) {
    const std::string name = fs::relative(entry.path(), bundle.folder).generic_string();
    const bool takes_part = name.find('/') != std::string::npos && !entry.is_directory();
    if (takes_part && !listed.contains(name))
      throw ConfigError(bundle.path_of(name) + ": is not in the list of " + kBundleFile +
                        ", expected no other files in the folders of the bundle");
  }
}

/// The file in a folder or below it.
std::optional<std::string> found_in(const std::string& place, const BundledFile& file) {
  const fs::path name = fs::path(file.name).filename();
  const auto is_it = [&](const fs::path& path) {
    return fs::is_regular_file(path) && fs::file_size(path) == file.bytes && trouble_with(path, file).empty();
  };
  if (is_it(place / name)) return (place / name).string();
  for (const auto& entry : fs::recursive_directory_iterator(place, fs::directory_options::skip_permission_denied))
    if (is_it(entry.path())) return entry.path().string();
  return std::nullopt;
}

std::optional<std::string> found_in_any(const std::vector<std::string>& places, const BundledFile& file) {
  for (const std::string& place : places)
    if (auto found = found_in(place, file)) return found;
  return std::nullopt;
}

void place_file(const std::string& source, const fs::path& target, bool copies) {
  make_folder(target.parent_path().string());
  std::error_code absent;
  fs::remove(target, absent);
  if (copies)
    fs::copy_file(source, target);
  else
    fs::create_symlink(fs::canonical(source), target);
}

}  // namespace

Bundle read_bundle(const std::string& folder) {
  constexpr int kFormat = 1;
  Bundle bundle{folder, {}};
  const std::string list = bundle.path_of(kBundleFile);
  const nlohmann::json document = read_json(list);
  ConfigObject object(document, list);
  if (object.integer("format", 0) != kFormat) object.refuse("format", fmt::format("{}", kFormat));
  const auto files = object.list("files");
  if (!files) object.refuse("files", "the list of the bundle's files");
  for (const ConfigObject& entry : *files) {
    bundle.files.push_back(read_file(entry));
    const BundledFile& file = bundle.files.back();
    if (!file.included) continue;
    if (const std::string trouble = trouble_with(bundle.path_of(file.name), file); !trouble.empty())
      throw ConfigError(entry.where() + ": " + bundle.path_of(file.name) + " " + trouble);
  }
  expect_all_listed(bundle);
  return bundle;
}

void place_files(const Bundle& bundle, const std::vector<std::string>& places, const std::string& folder) {
  std::string missing;
  for (const BundledFile& file : bundle.files) {
    const auto found = file.included ? bundle.path_of(file.name) : found_in_any(places, file);
    if (found)
      place_file(*found, fs::path(folder) / file.name, file.included);
    else
      missing += fmt::format("\n  {} ({} bytes, SHA-256 {})", fs::path(file.name).filename().string(), file.bytes,
                             file.sha256);
  }
  if (!missing.empty())
    throw ConfigError(bundle.path_of(kBundleFile) + ": these files are not part of the bundle, and were not found:" +
                      missing + "\ngive the folder that has them: --look-in FOLDER");
}

}  // namespace opal::ab
