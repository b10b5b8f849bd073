#include <opal/common/letter_case.hpp>
#include <opal/import_kit/class_rules.hpp>

#include <algorithm>
#include <cctype>

namespace opal {
namespace {

std::ptrdiff_t own_characters(const std::string& pattern) {
  return std::ranges::count_if(pattern, [](char c) { return c != '*' && c != '?'; });
}

bool same(char a, char b) {
  return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
}

bool is_ascii(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; });
}

/// fits_pattern() knows upper and lower case of ASCII by itself, and there may be many names.
std::vector<std::string> comparable(std::vector<std::string> names) {
  for (std::string& name : names)
    if (!is_ascii(name)) name = upper_case_letters(name);
  return names;
}

std::string type_of(const std::string& text) {
  const bool is_complete = text == ClassRules::kLeaveOut || text.find(':') != std::string::npos;
  return is_complete ? text : "opal:" + text;
}

bool fits_any(const std::vector<std::string>& names, const std::string& pattern) {
  return std::ranges::any_of(names, [&](const std::string& name) { return fits_pattern(name, pattern); });
}

}  // namespace

bool fits_pattern(const std::string& name, const std::string& pattern) {
  std::size_t n = 0, p = 0, star = std::string::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || same(pattern[p], name[n]))) {
      ++p;
      ++n;
    } else if (star != std::string::npos) {
      p = star + 1;
      n = ++resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string::npos;
}

ClassRules::ClassRules(const nlohmann::json& given, const std::map<std::string, std::string>& defaults) {
  for (const auto& [pattern, type] : given.items())
    rules_.push_back({pattern, upper_case_letters(pattern), type_of(type.get<std::string>()), true});
  for (const auto& [pattern, type] : defaults)
    rules_.push_back({pattern, upper_case_letters(pattern), type_of(type), false});
  std::ranges::stable_sort(rules_, [](const Rule& a, const Rule& b) {
    return a.is_given != b.is_given ? a.is_given : own_characters(a.pattern) > own_characters(b.pattern);
  });
}

const ClassRules::Rule* ClassRules::rule_for(const std::vector<std::string>& names) const {
  const std::vector<std::string> compared = comparable(names);
  const auto found = std::ranges::find_if(rules_, [&](const Rule& rule) { return fits_any(compared, rule.compared); });
  return found == rules_.end() ? nullptr : &*found;
}

std::optional<std::string> ClassRules::class_of(const std::vector<std::string>& names) const {
  const Rule* rule = rule_for(names);
  return rule == nullptr ? std::nullopt : std::optional<std::string>(rule->type);
}

std::vector<std::string> ClassRules::unused(const std::vector<std::string>& names) const {
  const std::vector<std::string> compared = comparable(names);
  std::vector<std::string> patterns;
  for (const Rule& rule : rules_)
    if (rule.is_given && !fits_any(compared, rule.compared)) patterns.push_back(rule.pattern);
  return patterns;
}

}  // namespace opal
