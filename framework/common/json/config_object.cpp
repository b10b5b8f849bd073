#include "common/json/config_object.hpp"

#include "common/phrases.hpp"
#include "common/spelling.hpp"

#include <opal/common/error.hpp>
#include <opal/common/geometry.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace opal {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestExcerpt = 80;

std::string excerpt(const json& value) {
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > kLongestExcerpt) text = text.substr(0, kLongestExcerpt) + "...";
  return text;
}

std::string number_text(double value) {
  return value == std::floor(value) && std::abs(value) < 1e9 ? std::to_string(static_cast<long>(value))
                                                             : json(value).dump();
}

std::string in_words(const std::string& type, const NumberRange& range) {
  const bool from = range.minimum != NumberRange{}.minimum, to = range.maximum != NumberRange{}.maximum;
  if (from && to) return type + " from " + number_text(range.minimum) + " to " + number_text(range.maximum);
  if (from) return type + " >= " + number_text(range.minimum);
  if (to) return type + " <= " + number_text(range.maximum);
  return type;
}

/// What an angle would be, were it in degrees; empty for what is none.
std::string degrees_in_words(const std::string& key, double value) {
  if (!key.ends_with("_rad") || !(std::abs(value) > 1 && std::abs(value) <= 360)) return "";
  return fmt::format("; {:g} degrees are {:.4g} rad", value, radians(value));
}

constexpr const char* kExpectedContext = "\"urn:opal:v1\", or a list of it and objects that define prefixes by IRIs";

/// A prefix and what it stands for; those of Opal's own context mean what they mean.
bool is_prefix(const std::string& prefix, const json& iri) {
  if (prefix.empty() || prefix == "opal" || prefix.find_first_of("@:/") != std::string::npos) return false;
  return iri.is_string() && iri.get_ref<const std::string&>().find(':') != std::string::npos;
}

bool are_prefixes(const json& definitions) {
  if (!definitions.is_object()) return false;
  for (const auto& [prefix, iri] : definitions.items())
    if (!is_prefix(prefix, iri)) return false;
  return true;
}

bool is_own_context(const json& context) {
  const json own = "urn:opal:v1";
  if (!context.is_array()) return context == own;
  if (context.empty() || context.front() != own) return false;
  return std::all_of(context.begin() + 1, context.end(), are_prefixes);
}

bool holds(const NumberRange& range, const json& value) {
  const double number = value.get<double>();
  return number >= range.minimum && number <= range.maximum;  // false for NaN
}

}  // namespace

ConfigObject::ConfigObject(const json& value, std::string file, std::string place)
    : value_(&value), file_(std::move(file)), place_(std::move(place)) {
  if (!value.is_object()) throw ConfigError(where() + ": " + excerpt(value) + ", expected an object");
}

const json* ConfigObject::find(const std::string& key) {
  asked_.insert(key);
  const auto found = value_->find(key);
  return found == value_->end() ? nullptr : &*found;
}

double ConfigObject::number(const std::string& key, double fallback, NumberRange range) {
  const json* value = find(key);
  if (!value) return fallback;
  if (!value->is_number()) refuse(key, in_words("a number", range));
  if (!holds(range, *value)) refuse(key, in_words("a number", range) + degrees_in_words(key, value->get<double>()));
  return value->get<double>();
}

int ConfigObject::integer(const std::string& key, int fallback, NumberRange range) {
  const json* value = find(key);
  if (!value) return fallback;
  constexpr NumberRange kInt{std::numeric_limits<int>::min(), std::numeric_limits<int>::max()};
  if (!value->is_number_integer() || !holds(range, *value)) refuse(key, in_words("an integer", range));
  if (!holds(kInt, *value)) refuse(key, in_words("an integer", kInt));
  return value->get<int>();
}

bool ConfigObject::boolean(const std::string& key, bool fallback) {
  const json* value = find(key);
  if (!value) return fallback;
  if (!value->is_boolean()) refuse(key, "true or false");
  return value->get<bool>();
}

std::string ConfigObject::text(const std::string& key, const std::string& fallback) {
  const json* value = find(key);
  if (!value) return fallback;
  if (!value->is_string() || value->get_ref<const std::string&>().empty()) refuse(key, "a text");
  return value->get<std::string>();
}

std::string ConfigObject::required_text(const std::string& key) {
  if (!find(key)) refuse(key, "a text");
  return text(key, "");
}

std::vector<std::string> ConfigObject::texts(const std::string& key) {
  const json* value = find(key);
  if (!value) return {};
  std::vector<std::string> texts;
  for (const json& item : value->is_array() ? *value : json::array({*value})) {
    if (!item.is_string() || item.get_ref<const std::string&>().empty()) refuse(key, "a list of texts");
    texts.push_back(item.get<std::string>());
  }
  return texts;
}

const json& ConfigObject::any(const std::string& key) {
  static const json none;
  const json* value = find(key);
  return value ? *value : none;
}

std::optional<ConfigObject> ConfigObject::object(const std::string& key) {
  const json* value = find(key);
  if (!value) return std::nullopt;
  return ConfigObject(*value, file_, place_ + "/" + escape_pointer_step(key));
}

std::optional<std::vector<ConfigObject>> ConfigObject::list(const std::string& key) {
  const json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_array()) refuse(key, "a list");
  std::vector<ConfigObject> items;
  for (std::size_t k = 0; k < value->size(); ++k)
    items.emplace_back((*value)[k], file_, place_ + "/" + escape_pointer_step(key) + "/" + std::to_string(k));
  return items;
}

void ConfigObject::expect_type(const std::string& type) {
  const json* context = find("@context");
  if (!context || !is_own_context(*context)) refuse("@context", kExpectedContext);
  if (required_text("@type") != type) refuse("@type", json(type).dump());
}

void ConfigObject::expect_no_more() const {
  for (const auto& [key, ignored] : value_->items()) {
    if (asked_.count(key)) continue;
    throw ConfigError(where(key) + ": unknown key, expected one of: " + listed(asked_));
  }
}

std::string ConfigObject::where(const std::string& key) const {
  return file_ + ": " + place_ + "/" + escape_pointer_step(key);
}

std::string ConfigObject::where() const { return file_ + ": " + (place_.empty() ? "/" : place_); }

void ConfigObject::refuse(const std::string& key, const std::string& expected) const {
  const auto found = value_->find(key);
  if (found == value_->end())
    for (const auto& [other, ignored] : value_->items())
      if (!asked_.count(other) && is_misspelt(other, key))
        throw ConfigError(where(other) + ": unknown key, did you mean \"" + key + "\"?");
  throw ConfigError(where(key) + ": " + (found == value_->end() ? "absent" : excerpt(*found)) + ", expected " +
                    expected);
}

std::string beside(const std::string& document, const std::string& path) {
  return (std::filesystem::path(document).parent_path() / path).lexically_normal().string();
}

}  // namespace opal
