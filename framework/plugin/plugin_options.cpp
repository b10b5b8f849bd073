#include "plugin/plugin_options.hpp"

#include "common/phrases.hpp"
#include "plugin/refusal.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

using nlohmann::json;

bool is_text(const json& value) { return value.is_string(); }

bool has_type(const std::string& type, const json& value) {
  if (type == "object") return value.is_object() && std::all_of(value.begin(), value.end(), is_text);
  if (type == "boolean") return value.is_boolean();
  if (type == "string") return value.is_string();
  if (type == "integer") return value.is_number_integer();
  return value.is_number() && std::isfinite(value.get<double>());
}

std::string type_in_words(const std::string& type) {
  if (type == "boolean") return "true or false";
  if (type == "object") return "an object of texts";
  return (type == "integer" ? "an " : "a ") + type;
}

std::string names_of(const std::vector<OptionInfo>& described) { return listed_by(described, &OptionInfo::name); }

void require_known(const std::string& type_name, const std::vector<OptionInfo>& described, const json& given) {
  for (const auto& [name, ignored] : given.items()) {
    const auto has_this_name = [&key = name](const OptionInfo& option) { return option.name == key; };
    if (std::none_of(described.begin(), described.end(), has_this_name))
      refuse_option(
          type_name, name,
          described.empty() ? "unknown, there are no options" : "unknown, expected one of: " + names_of(described));
  }
}

}  // namespace

bool is_acceptable(const OptionInfo& option, const json& value) {
  if (value.is_null()) return option.default_value.is_null();
  return has_type(option.type, value) && (option.minimum.is_null() || option.minimum <= value) &&
         (option.maximum.is_null() || value <= option.maximum);
}

std::string accepted_values(const OptionInfo& option) {
  std::string text = type_in_words(option.type);
  if (!option.minimum.is_null() && !option.maximum.is_null())
    text += " from " + option.minimum.dump() + " to " + option.maximum.dump();
  else if (!option.minimum.is_null())
    text += " >= " + option.minimum.dump();
  else if (!option.maximum.is_null())
    text += " <= " + option.maximum.dump();
  if (option.default_value.is_null()) text += ", or null";
  return option.unit.empty() ? text : text + " [" + option.unit + "]";
}

json complete_options(const std::string& type_name, const std::vector<OptionInfo>& described, const json& given) {
  if (!given.is_object() && !given.is_null())
    throw PluginError(type_name + ": options: " + given.dump() + ", expected an object");
  if (given.is_object()) require_known(type_name, described, given);
  json complete = json::object();
  for (const OptionInfo& option : described) {
    const bool is_given = given.is_object() && given.contains(option.name);
    const json& value = is_given ? given.at(option.name) : option.default_value;
    if (!is_acceptable(option, value))
      refuse_option(type_name, option.name, value.dump() + ", expected " + accepted_values(option));
    complete[option.name] = option.type == "number" && !value.is_null() ? json(value.get<double>()) : value;
  }
  return complete;
}

}  // namespace opal
