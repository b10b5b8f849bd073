#include <opal/import_kit/length_unit.hpp>

#include <opal/common/number_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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
  if (found != kUnits.end()) return LengthUnit{name, found->second};
  const auto metres = parse_number<double>(name);
  if (!metres || !std::isfinite(*metres) || *metres <= 0) return std::nullopt;
  return LengthUnit{"units of " + name + " m", *metres};
}

std::string length_unit_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, metres] : kUnits) names.push_back(name);
  return fmt::format("{}, or its length in metres", fmt::join(names, ", "));
}

std::string length_units_that_fit(double drawn, double least_m, double most_m) {
  std::string text;
  for (const auto& [name, metres] : kUnits)
    if (const double length_m = metres * drawn; length_m >= least_m && length_m <= most_m)
      text += fmt::format("; in {0} they would be {1:.2f} m (--set unit={0})", name, length_m);
  return text;
}

}  // namespace opal
