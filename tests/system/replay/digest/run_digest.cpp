#include "run_digest.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

using nlohmann::ordered_json;

namespace {

/// Numbers in texts are rounded: one of them may be by one more.
constexpr double kRoundingInTexts = 1e-3;

/// Digits, and what follows a point between them.
std::size_t end_of_number(const std::string& text, std::size_t at) {
  const auto is_digit = [&](std::size_t k) {
    return k < text.size() && std::isdigit(static_cast<unsigned char>(text[k]));
  };
  while (is_digit(at)) ++at;
  if (at < text.size() && text[at] == '.' && is_digit(at + 1))
    for (++at; is_digit(at);) ++at;
  return at;
}

}  // namespace

bool RunDigest::are_alike(double found, double golden, double size, bool is_text) const {
  return std::abs(found - golden) <= (is_text ? kRoundingInTexts * size + 1 : rounding_ * (size + 1));
}

void RunDigest::add(const std::string& field, double number) {
  Sums& sums = fields_[field];
  ++sums.count;
  sums.sum += number;
  sums.by_place += static_cast<double>(sums.count) * number;
  sums.size += std::abs(number);
}

void RunDigest::add_text(const std::string& field, const std::string& text) {
  std::string words;
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_number(text, at);
    if (end == at) {
      words += text[at++];
      continue;
    }
    words += '#';
    numbers.push_back(std::stod(text.substr(at, end - at)));
    at = end;
  }
  const std::string name = field + " '" + words + "'";
  if (numbers.empty()) add(name, 1);
  for (const double number : numbers) add(name, number);
}

void RunDigest::take(const std::string& field, const ordered_json& value) {
  if (value.is_object()) {
    for (const auto& [name, inner] : value.items()) take(field + '.' + name, inner);
  } else if (value.is_array()) {
    add(field + " length", static_cast<double>(value.size()));
    for (const ordered_json& inner : value) take(field, inner);
  } else if (value.is_string()) {
    add_text(field, value.get<std::string>());
  } else if (value.is_null()) {
    add_text(field, "null");
  } else {
    add(field, value.is_boolean() ? static_cast<double>(value.get<bool>()) : value.get<double>());
  }
}

ordered_json RunDigest::json() const {
  auto all = ordered_json::object();
  const auto short_number = [](double number) { return std::stod(fmt::format("{:.11g}", number)); };
  for (const auto& [field, sums] : fields_)
    all[field] = {sums.count, short_number(sums.sum), short_number(sums.by_place / static_cast<double>(sums.count))};
  return all;
}

std::vector<std::string> RunDigest::differences_from(const ordered_json& golden) const {
  std::vector<std::string> lines;
  const ordered_json found = json();
  for (const auto& [field, sums] : fields_) {
    if (!golden.contains(field)) {
      lines.push_back(fmt::format("{}: found {}, never before", field, found[field].dump()));
      continue;
    }
    const ordered_json &now = found[field], &was = golden[field];
    const bool is_text = field.back() == '\'';
    const bool is_same = now[0] == was[0] && are_alike(now[1], was[1], sums.size, is_text) &&
                         are_alike(now[2], was[2], sums.size, is_text);
    if (!is_same) lines.push_back(fmt::format("{}: found {}, golden {}", field, now.dump(), was.dump()));
  }
  for (const auto& [field, was] : golden.items())
    if (!fields_.contains(field)) lines.push_back(fmt::format("{}: not found, golden {}", field, was.dump()));
  return lines;
}
