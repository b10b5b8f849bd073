#pragma once

// Part of ifc_model.cpp: which classes there are, and what they are kinds of.

#include "values.hpp"

#include <ifcpp/IFC4/include/IfcBeam.h>
#include <ifcpp/IFC4/include/IfcBuildingElementPart.h>
#include <ifcpp/IFC4/include/IfcBuildingElementProxy.h>
#include <ifcpp/IFC4/include/IfcChimney.h>
#include <ifcpp/IFC4/include/IfcCivilElement.h>
#include <ifcpp/IFC4/include/IfcColumn.h>
#include <ifcpp/IFC4/include/IfcCovering.h>
#include <ifcpp/IFC4/include/IfcCurtainWall.h>
#include <ifcpp/IFC4/include/IfcDistributionElement.h>
#include <ifcpp/IFC4/include/IfcDoor.h>
#include <ifcpp/IFC4/include/IfcElementAssembly.h>
#include <ifcpp/IFC4/include/IfcElementComponent.h>
#include <ifcpp/IFC4/include/IfcFooting.h>
#include <ifcpp/IFC4/include/IfcFurnishingElement.h>
#include <ifcpp/IFC4/include/IfcGeographicElement.h>
#include <ifcpp/IFC4/include/IfcMember.h>
#include <ifcpp/IFC4/include/IfcPile.h>
#include <ifcpp/IFC4/include/IfcPlate.h>
#include <ifcpp/IFC4/include/IfcRailing.h>
#include <ifcpp/IFC4/include/IfcRamp.h>
#include <ifcpp/IFC4/include/IfcRampFlight.h>
#include <ifcpp/IFC4/include/IfcRoof.h>
#include <ifcpp/IFC4/include/IfcShadingDevice.h>
#include <ifcpp/IFC4/include/IfcSlab.h>
#include <ifcpp/IFC4/include/IfcStair.h>
#include <ifcpp/IFC4/include/IfcStairFlight.h>
#include <ifcpp/IFC4/include/IfcTransportElement.h>
#include <ifcpp/IFC4/include/IfcWall.h>
#include <ifcpp/IFC4/include/IfcWindow.h>

namespace opal::ifc_importer::ifcpp {

struct KnownClass {
  const char* name;
  bool (*is)(const BuildingEntity&);
};

template <class T>
bool is(const BuildingEntity& entity) {
  return dynamic_cast<const T*>(&entity) != nullptr;
}

/// The classes by which things are told apart; all are kinds of IfcElement.
inline constexpr KnownClass kKnownClasses[] = {
    {"IfcWall", is<IfcWall>},
    {"IfcColumn", is<IfcColumn>},
    {"IfcDoor", is<IfcDoor>},
    {"IfcWindow", is<IfcWindow>},
    {"IfcPlate", is<IfcPlate>},
    {"IfcMember", is<IfcMember>},
    {"IfcCurtainWall", is<IfcCurtainWall>},
    {"IfcSlab", is<IfcSlab>},
    {"IfcRoof", is<IfcRoof>},
    {"IfcStair", is<IfcStair>},
    {"IfcStairFlight", is<IfcStairFlight>},
    {"IfcRamp", is<IfcRamp>},
    {"IfcRampFlight", is<IfcRampFlight>},
    {"IfcRailing", is<IfcRailing>},
    {"IfcBeam", is<IfcBeam>},
    {"IfcCovering", is<IfcCovering>},
    {"IfcFooting", is<IfcFooting>},
    {"IfcPile", is<IfcPile>},
    {"IfcChimney", is<IfcChimney>},
    {"IfcShadingDevice", is<IfcShadingDevice>},
    {"IfcBuildingElementPart", is<IfcBuildingElementPart>},
    {"IfcBuildingElementProxy", is<IfcBuildingElementProxy>},
    {"IfcElementAssembly", is<IfcElementAssembly>},
    {"IfcElementComponent", is<IfcElementComponent>},
    {"IfcFurnishingElement", is<IfcFurnishingElement>},
    {"IfcDistributionElement", is<IfcDistributionElement>},
    {"IfcTransportElement", is<IfcTransportElement>},
    {"IfcGeographicElement", is<IfcGeographicElement>},
    {"IfcCivilElement", is<IfcCivilElement>},
    {"IfcElement", is<IfcElement>},
};

/// Its own class first.
inline std::vector<std::string> classes_of(const BuildingEntity& entity) {
  std::vector<std::string> classes{entity.className()};
  for (const KnownClass& known : kKnownClasses)
    if (known.is(entity) && classes.front() != known.name) classes.push_back(known.name);
  return classes;
}

}  // namespace opal::ifc_importer::ifcpp
