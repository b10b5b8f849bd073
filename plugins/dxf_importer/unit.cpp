#include "unit.hpp"

#include <fmt/format.h>

#include <array>

namespace opal::dxf_importer {
namespace {

struct CodedUnit {
  int insunits;
  const char* name;
  double metres;
};

// DXF reference, header variable $INSUNITS.
constexpr std::array<CodedUnit, 7> kUnits{{{6, "m", 1},
                                           {14, "dm", 0.1},
                                           {5, "cm", 0.01},
                                           {4, "mm", 0.001},
                                           {1, "in", 0.0254},
                                           {2, "ft", 0.3048},
                                           {10, "yd", 0.9144}}};

// Longer than a foot by 2 parts in a million.
constexpr int kSurveyFoot = 21;
constexpr double kSurveyFoot_m = 1200.0 / 3937;

}  // namespace

std::optional<Unit> unit_called(const std::string& name) {
  for (const CodedUnit& unit : kUnits)
    if (name == unit.name) return Unit{unit.name, unit.metres};
  return std::nullopt;
}

std::optional<Unit> unit_of_insunits(int code) {
  if (code == kSurveyFoot) return Unit{"ft", kSurveyFoot_m};
  for (const CodedUnit& unit : kUnits)
    if (code == unit.insunits) return Unit{unit.name, unit.metres};
  return std::nullopt;
}

std::string unit_names() {
  std::vector<std::string_view> names;
  for (const CodedUnit& unit : kUnits) names.push_back(unit.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace opal::dxf_importer
