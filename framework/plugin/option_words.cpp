#include <opal/plugin/plugin_description.hpp>

#include "plugin/refusal.hpp"

#include <opal/common/strict_json.hpp>

#include <algorithm>

namespace opal {
namespace {

using nlohmann::json;

/// NAME as far as a described option goes: names of classes and layers may hold dots and signs of their own.
const OptionInfo* find_option(const std::vector<OptionInfo>& described, const std::string& name) {
  const auto found = std::ranges::find_if(described, [&](const OptionInfo& option) { return option.name == name; });
  return found == described.end() ? nullptr : &*found;
}

json value_of(const std::string& type_name, const OptionInfo& option, const std::string& text) {
  if (option.type == "string") return text;
  try {
    return parse_json(text, option.name);
  } catch (const JsonError&) {
    refuse_option(type_name, option.name, "\"" + text + "\", expected " + accepted_values(option));
  }
}

}  // namespace

json parse_options(const std::string& type_name, const std::vector<OptionInfo>& described,
                   const std::vector<std::string>& words) {
  json options = json::object();
  for (const std::string& word : words) {
    const std::size_t dot = word.find('.'), first_sign = word.find('=');
    const bool is_entry = dot < first_sign;
    const std::size_t sign = is_entry ? word.rfind('=') : first_sign;
    if (sign == std::string::npos) throw PluginError(type_name + ": \"" + word + "\", expected NAME=VALUE");
    const std::string name = word.substr(0, is_entry ? dot : sign), value = word.substr(sign + 1);
    const OptionInfo* option = find_option(described, name);
    if (option == nullptr)
      options[name] = value;  // complete_options lists what there is
    else if (is_entry && option->type != "object")
      refuse_option(type_name, name, "has no entries, expected " + name + "=VALUE");
    else if (is_entry)
      options[name][word.substr(dot + 1, sign - dot - 1)] = value;
    else
      options[name] = value_of(type_name, *option, value);
  }
  return options;
}

}  // namespace opal
