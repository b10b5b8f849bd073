#include "versions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::postgis_store {
namespace {

std::string existing_versions(Session& session, const std::string& building) {
  std::vector<std::string> numbers;
  for (const Row& row :
       session.ask("SELECT version FROM opal.versions WHERE building = $1 ORDER BY version", {building}))
    numbers.push_back(row[0]);
  return fmt::format("{}", fmt::join(numbers, ", "));
}

}  // namespace

std::string quoted(const std::string& text) { return "'" + text + "'"; }

void expect_name(const std::string& what, const std::string& name) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (name.empty()) throw StoreError(what + " without a name, expected one");
  if (std::any_of(name.begin(), name.end(), is_control))
    throw StoreError(what + " with control characters in its name, expected none");
}

void expect_version(int version) {
  if (version < 0)
    throw StoreError(fmt::format("version {}, expected a number from 1 on, or 0 for the newest", version));
}

void expect_storable(const std::string& text, const std::string& what) {
  if (text.find('\0') != std::string::npos || text.find("\\u0000") != std::string::npos)
    throw StoreError(what + " holds the character U+0000, which PostgreSQL cannot store");
}

std::string utc_of(const std::string& column) {
  return "to_char(" + column + " AT TIME ZONE 'UTC', 'YYYY-MM-DD\"T\"HH24:MI:SS\"Z\"')";
}

std::string version_columns() {
  return "building, version, " + utc_of("pushed_at") + ", pushed_by, message, map_name, objects, features, patterns";
}

StoredVersion version_of(const Row& row) {
  return {row.at(0),
          std::stoi(row.at(1)),
          row.at(2),
          row.at(3),
          row.at(4),
          row.at(5),
          std::stoi(row.at(6)),
          std::stoi(row.at(7)),
          std::stoi(row.at(8))};
}

FoundVersion find_version(Session& session, const std::string& where, const std::string& building, int version) {
  const auto rows = session.ask("SELECT " + version_columns() +
                                    ", map FROM opal.versions WHERE building = $1 AND "
                                    "(version = $2::integer OR $2::integer = 0 AND is_newest)",
                                {building, std::to_string(version)});
  if (!rows.empty()) return {rows[0].back(), version_of(rows[0])};
  const std::string numbers = existing_versions(session, building);
  if (numbers.empty()) throw StoreError(where + ": has no map of building " + quoted(building));
  throw StoreError(
      fmt::format("{}: has no version {} of building {}; there is: {}", where, version, quoted(building), numbers));
}

}  // namespace opal::postgis_store
