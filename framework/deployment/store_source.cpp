#include "deployment/store_source.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>

#include <algorithm>
#include <string_view>

namespace opal {
namespace {

constexpr std::string_view kScheme = "store:";
constexpr std::string_view kNewest = "newest";

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

int version_of(std::string_view digits, const std::string& source) {
  const auto version = parse_number<int>(digits);
  if (!version || *version < 1)
    throw ConfigError(source + ": version " + std::string(digits) + ", expected a number from 1 on");
  return *version;
}

}  // namespace

std::optional<StoreSource> read_store_source(const std::string& text) {
  if (!text.starts_with(kScheme)) return std::nullopt;
  const std::string_view rest = std::string_view(text).substr(kScheme.size());
  StoreSource source{std::string(rest), 0};
  if (const std::size_t at = rest.rfind('@'); at != std::string_view::npos) {
    const std::string_view suffix = rest.substr(at + 1);
    if (is_number(suffix)) source.version = version_of(suffix, text);
    if (is_number(suffix) || suffix == kNewest) source.building = rest.substr(0, at);
  }
  if (source.building.empty())
    throw ConfigError(text + ": no building, expected store:BUILDING or store:BUILDING@VERSION");
  return source;
}

std::string text_of(const StoreSource& source) {
  std::string text = std::string(kScheme) + source.building;
  if (source.version > 0) return text + "@" + std::to_string(source.version);
  const auto again = read_store_source(text);
  return again->building == source.building && again->version == 0 ? text : text + "@" + std::string(kNewest);
}

}  // namespace opal
