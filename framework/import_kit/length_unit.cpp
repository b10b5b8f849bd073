#include <opal/import_kit/length_unit.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace opal {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 7> kUnits{
    {{"m", 1}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}, {"yd", 0.9144}}};

}  // namespace

std::optional<LengthUnit> length_unit_called(const std::string& name) {
  const auto found = std::find_if(kUnits.begin(), kUnits.end(), [&](const auto& unit) { return unit.first == name; });
  return found == kUnits.end() ? std::nullopt : std::optional(LengthUnit{name, found->second});
}

std::string length_unit_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, metres] : kUnits) names.push_back(name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace opal
