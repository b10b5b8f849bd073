#include "session/stored_maps.hpp"

#include "common/phrases.hpp"
#include "session/map_cache.hpp"

#include <opal/common/error.hpp>
#include <opal/common/warning.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>

namespace opal::session {
namespace {

constexpr const char* kNoStore =
    "no plugin offers a MapStore, which sources such as store:hall and opal map push, pull and list need; "
    "opal:PostgisStore "
    "is built where libpqxx is installed (Debian: libpqxx-dev)";

std::vector<std::string> store_types(const opal::PluginRegistry& registry) {
  std::vector<std::string> names;
  for (const opal::RegisteredType& type : registry.types())
    if (type.kind == opal::PluginKind::map_store) names.push_back(type.info.name);
  return names;
}

/// "3 days ago", "just now" by this machine's clock.
std::string age_of(const std::string& utc) {
  std::tm moment{};
  if (strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%SZ", &moment) == nullptr) return "at an unknown time";
  const double age_s = std::difftime(std::time(nullptr), timegm(&moment));
  if (age_s < -60) return "in the future, by this machine's clock";
  if (age_s < 120) return "just now";
  if (age_s < 2 * 3600) return fmt::format("{} minutes ago", std::lround(age_s / 60));
  if (age_s < 48 * 3600) return fmt::format("{} hours ago", std::lround(age_s / 3600));
  return fmt::format("{} days ago", std::lround(age_s / 86400));
}

/// A cache that cannot be written keeps nobody from working.
void keep(const MapCache& cache, const std::string& where, const opal::StoreSource& source,
          const opal::StoredMap& map) {
  try {
    cache.keep(where, source, map);
  } catch (const opal::Error& error) {
    opal::warn(fmt::format("opal: the map is not kept for times without its store: {}", error.what()));
  }
}

opal::StoredMap pull_or_find(const opal::MapStore& store, const MapCache& cache, const opal::StoreSource& source) {
  try {
    opal::StoredMap pulled = store.pull(source.building, source.version);
    keep(cache, store.where(), source, pulled);
    opal::warn(fmt::format("map: {}, from {}", described(pulled.version), store.where()));
    return pulled;
  } catch (const opal::StoreUnreachable& error) {
    const auto kept = cache.find(store.where(), source);
    if (!kept)
      throw opal::StoreUnreachable(std::string(error.what()) + "; and " + opal::text_of(source) +
                                   " was never kept from it on this machine");
    opal::warn(fmt::format("opal: the map store cannot be reached: {}", error.what()));
    opal::warn(fmt::format("map: {}, as pulled {} ({}), from {}", described(kept->map.version), age_of(kept->pulled_at),
                           kept->pulled_at, kept->file));
    return kept->map;
  }
}

}  // namespace

std::string map_store_type(const opal::PluginRegistry& registry) {
  if (const char* named = std::getenv("OPAL_MAP_STORE"); named != nullptr && *named != '\0') return named;
  const std::vector<std::string> names = store_types(registry);
  if (names.empty()) throw opal::PluginError(kNoStore);
  if (names.size() == 1) return names.front();
  throw opal::PluginError("plugins offer several map stores: " + opal::listed(names) + "; name one in OPAL_MAP_STORE");
}

std::shared_ptr<const opal::MapStore> map_store(const opal::PluginRegistry& registry) {
  return registry.make<opal::MapStore>(map_store_type(registry));
}

VersionedMap load_stored_map(const opal::PluginRegistry& registry, const opal::StoreSource& source) {
  const auto store = map_store(registry);
  const opal::StoredMap stored = pull_or_find(*store, MapCache::usual(), source);
  const opal::StoreSource version{stored.version.building, stored.version.version};
  return {opal::SemanticMap::parse(stored.document, opal::text_of(version)), version};
}

std::string described(const opal::StoredVersion& version) {
  const std::string text = fmt::format("version {} of '{}', pushed {} by {}", version.version, version.building,
                                       version.pushed_at, version.pushed_by);
  return version.message.empty() ? text : text + ": " + version.message;
}

}  // namespace opal::session
