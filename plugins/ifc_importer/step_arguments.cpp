#include "step_arguments.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace opal::ifc_importer {
namespace {

std::string joined(const std::vector<std::string_view>& parts) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) text.append(k == 0 ? "" : ",").append(parts[k]);
  return text;
}

/// What stands in the outermost parentheses of a text; empty if it has none.
std::string_view inside(std::string_view text) {
  const std::size_t begin = text.find('('), end = text.rfind(')');
  return begin == std::string_view::npos || end == std::string_view::npos || end < begin
             ? ""
             : text.substr(begin + 1, end - begin - 1);
}

bool is_reference_to(std::string_view argument, const std::vector<int>& numbers) {
  const int number = referred_by(argument);
  return number >= 0 && std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

int referred_by(std::string_view argument) {
  int number = -1;
  if (argument.starts_with('#')) std::from_chars(argument.data() + 1, argument.data() + argument.size(), number);
  return number;
}

std::vector<std::string_view> split_arguments(std::string_view arguments) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    if (arguments[at] == '\'') at = std::min(arguments.find('\'', at + 1), arguments.size() - 1);
    depth += (arguments[at] == '(') - (arguments[at] == ')');
    if (arguments[at] != ',' || depth != 0) continue;
    parts.push_back(arguments.substr(begin, at - begin));
    begin = at + 1;
  }
  parts.push_back(arguments.substr(begin));
  return parts;
}

std::string arguments_of_ifc4(const StepInstance& instance) {
  const bool is_placement = instance.type == "IFCGRIDPLACEMENT",
             is_list = instance.type.starts_with("IFCCARTESIANPOINTLIST"),
             is_faces = instance.type == "IFCTRIANGULATEDFACESET";
  if (!is_placement && !is_list && !is_faces) return std::string(instance.arguments);
  std::vector<std::string_view> parts = split_arguments(instance.arguments);
  if (is_placement && parts.size() == 3) parts.erase(parts.begin());
  if (is_list && parts.size() == 2) parts.pop_back();
  if (is_faces && parts.size() == 5 && trimmed(parts[1]).starts_with('.')) std::swap(parts[1], parts[2]);
  return joined(parts);
}

std::string arguments_without(std::string_view arguments, const std::vector<int>& numbers) {
  std::vector<std::string> kept;
  for (const std::string_view argument : split_arguments(arguments)) {
    const std::string_view part = trimmed(argument);
    if (!part.starts_with('(')) {
      kept.emplace_back(is_reference_to(part, numbers) ? "$" : argument);
      continue;
    }
    std::vector<std::string_view> members = split_arguments(inside(part));
    std::erase_if(members, [&](std::string_view member) { return is_reference_to(trimmed(member), numbers); });
    kept.push_back("(" + joined(members) + ")");
  }
  return joined({kept.begin(), kept.end()});
}

std::vector<IndexedSegment> indexed_segments(std::string_view argument) {
  std::vector<IndexedSegment> segments;
  for (std::string_view part : split_arguments(inside(argument))) {
    part = trimmed(part);
    segments.push_back({part.starts_with("IFCARCINDEX"), {}});
    if (!segments.back().is_arc && !part.starts_with("IFCLINEINDEX")) continue;
    for (std::string_view number : split_arguments(inside(inside(part)))) {
      number = trimmed(number);
      int point = 0;
      std::from_chars(number.data(), number.data() + number.size(), point);
      segments.back().points.push_back(point);
    }
  }
  return segments;
}

}  // namespace opal::ifc_importer
