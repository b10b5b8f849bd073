#pragma once

// Part of ifc_model.cpp: the unit of length, by IfcUnitAssignment alone.

#include "values.hpp"

#include <opal/import_kit/length_unit.hpp>

#include <ifcpp/IFC4/include/IfcConversionBasedUnit.h>
#include <ifcpp/IFC4/include/IfcLengthMeasure.h>
#include <ifcpp/IFC4/include/IfcMeasureWithUnit.h>
#include <ifcpp/IFC4/include/IfcPositiveLengthMeasure.h>
#include <ifcpp/IFC4/include/IfcProject.h>
#include <ifcpp/IFC4/include/IfcRatioMeasure.h>
#include <ifcpp/IFC4/include/IfcSIPrefix.h>
#include <ifcpp/IFC4/include/IfcSIUnit.h>
#include <ifcpp/IFC4/include/IfcUnitAssignment.h>
#include <ifcpp/IFC4/include/IfcUnitEnum.h>
#include <ifcpp/IFC4/include/IfcValue.h>

#include <ifcpp/model/UnitConverter.h>

namespace opal::ifc_importer::ifcpp {

inline double factor_of(const shared_ptr<IfcSIPrefix>& prefix) {
  if (!prefix) return 1;
  constexpr double kFactors[] = {1e18, 1e15, 1e12, 1e9,  1e6,  1e3,   1e2,   1e1,
                                 1e-1, 1e-2, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-18};
  const auto position = static_cast<std::size_t>(prefix->m_enum);
  return position < std::size(kFactors) ? kFactors[position] : 1;
}

inline double value_of(const shared_ptr<IfcValue>& value) {
  if (const auto length = as<IfcLengthMeasure>(value)) return number_of(length, "value");
  if (const auto ratio = as<IfcRatioMeasure>(value)) return number_of(ratio, "value");
  if (const auto length = as<IfcPositiveLengthMeasure>(value)) return number_of(length, "value");
  if (const auto real = as<IfcReal>(value)) return number_of(real, "value");
  throw Unreadable("has a conversion factor that is no number");
}

inline LengthUnit length_unit(const shared_ptr<IfcNamedUnit>& unit, int depth = 0) {
  if (const auto si = as<IfcSIUnit>(unit)) {
    const double metres = factor_of(si->m_Prefix);
    return {metres == 1 ? "m" : metres == 1e-3 ? "mm" : metres == 1e-2 ? "cm" : std::to_string(metres) + " m", metres};
  }
  const auto converted = as<IfcConversionBasedUnit>(unit);
  if (!converted || !converted->m_ConversionFactor || depth > 3)
    throw Unreadable("has a length unit that is not defined by metres");
  const LengthUnit base = length_unit(as<IfcNamedUnit>(converted->m_ConversionFactor->m_UnitComponent), depth + 1);
  return {text_of(converted->m_Name), value_of(converted->m_ConversionFactor->m_ValueComponent) * base.metres};
}

/// @throws Unreadable if the project assigns no length unit, or one that makes no sense.
inline LengthUnit length_unit(const shared_ptr<IfcProject>& project) {
  if (project && project->m_UnitsInContext)
    for (const auto& unit : project->m_UnitsInContext->m_Units) {
      const auto named = as<IfcNamedUnit>(unit);
      if (!named || !named->m_UnitType || named->m_UnitType->m_enum != IfcUnitEnum::ENUM_LENGTHUNIT) continue;
      const LengthUnit length = length_unit(named);
      if (!(length.metres > 1e-7 && length.metres < 1e7))
        throw Unreadable("has a length unit of " + std::to_string(length.metres) + " m");
      return length;
    }
  throw Unreadable("assigns no unit of length (IfcProject.UnitsInContext)");
}

}  // namespace opal::ifc_importer::ifcpp
