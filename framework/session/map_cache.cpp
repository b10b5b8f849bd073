#include "session/map_cache.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "common/text_file.hpp"
#include "common/utc_time.hpp"
#include "common/whole_file.hpp"
#include "deployment/cache_folder.hpp"

#include <fmt/format.h>

#include <cctype>

namespace opal::session {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A file name that no two texts share: all but letters, digits, '-' and '_' as %XX.
std::string as_file_name(const std::string& text) {
  std::string name;
  for (const unsigned char c : text) {
    const bool plain = std::isalnum(c) != 0 || c == '-' || c == '_';
    name += plain ? std::string(1, static_cast<char>(c)) : fmt::format("%{:02X}", c);
  }
  return name;
}

json to_json(const opal::StoredVersion& version) {
  return {{"building", version.building},   {"version", version.version},   {"pushed_at", version.pushed_at},
          {"pushed_by", version.pushed_by}, {"message", version.message},   {"map_name", version.map_name},
          {"objects", version.objects},     {"features", version.features}, {"patterns", version.patterns}};
}

opal::StoredVersion version_of(const json& object) {
  return {object.at("building"),  object.at("version"),  object.at("pushed_at"),
          object.at("pushed_by"), object.at("message"),  object.at("map_name"),
          object.at("objects"),   object.at("features"), object.at("patterns")};
}

}  // namespace

MapCache MapCache::usual() { return MapCache(opal::cache_folder("OPAL_MAP_CACHE", "maps")); }

fs::path MapCache::file_of(const std::string& where, const opal::StoreSource& source) const {
  const std::string version = source.version > 0 ? std::to_string(source.version) : "newest";
  return folder_ / as_file_name(where) / (as_file_name(source.building) + "@" + version + ".json");
}

std::optional<MapCache::Entry> MapCache::find(const std::string& where, const opal::StoreSource& source) const {
  if (folder_.empty()) return std::nullopt;
  const fs::path file = file_of(where, source);
  if (!fs::exists(file)) return std::nullopt;
  opal::JsonLimits limits;
  limits.bytes *= 2;  // the document stands in it as a text
  const json cached = opal::read_json(file.string(), limits);
  try {
    return Entry{{version_of(cached.at("version")), cached.at("document")}, cached.at("pulled_at"), file.string()};
  } catch (const json::exception& error) {
    throw opal::Error(file.string() + ": is no map that Opal has kept: " + error.what());
  }
}

std::string MapCache::keep(const std::string& where, const opal::StoreSource& source,
                           const opal::StoredMap& map) const {
  if (folder_.empty()) return {};
  const fs::path file = file_of(where, source);
  opal::make_folder(file.parent_path().string());
  const json cached{
      {"where", where}, {"version", to_json(map.version)}, {"pulled_at", opal::now_utc()}, {"document", map.document}};
  opal::write_text(file.string(), cached.dump(1));
  return file.string();
}

}  // namespace opal::session
