#include "unit.hpp"

#include <algorithm>
#include <array>

namespace opal::dxf_importer {
namespace {

struct CodedUnit {
  int insunits;
  const char* name;
};

// DXF reference, header variable $INSUNITS.
constexpr std::array<CodedUnit, 7> kUnits{
    {{6, "m"}, {14, "dm"}, {5, "cm"}, {4, "mm"}, {1, "in"}, {2, "ft"}, {10, "yd"}}};

// Longer than a foot by 2 parts in a million.
constexpr int kSurveyFoot = 21;
constexpr double kSurveyFoot_m = 1200.0 / 3937;

}  // namespace

std::optional<LengthUnit> unit_of_insunits(int code) {
  if (code == kSurveyFoot) return LengthUnit{"ft", kSurveyFoot_m};
  const auto found = std::ranges::find_if(kUnits, [&](const CodedUnit& unit) { return unit.insunits == code; });
  return found == kUnits.end() ? std::nullopt : length_unit_called(found->name);
}

}  // namespace opal::dxf_importer
