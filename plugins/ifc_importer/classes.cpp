#include "classes.hpp"

#include "glass.hpp"

#include <opal/common/error.hpp>

#include <array>

namespace opal::ifc_importer {
namespace {

using Kind = Treatment::Kind;

// clang-format off
constexpr std::array kSolid{"IfcWall",        "IfcColumn",  "IfcMember",     "IfcPlate", "IfcCurtainWall", "IfcSlab",
                            "IfcRoof",        "IfcStair",   "IfcStairFlight", "IfcRamp",  "IfcRampFlight",  "IfcRailing",
                            "IfcBeam",        "IfcCovering", "IfcFooting",    "IfcPile",  "IfcChimney",     "IfcShadingDevice",
                            "IfcBuildingElementPart", "IfcElementAssembly"};
// clang-format on
struct LeftOut {
  const char* name;
  const char* reason;
};
constexpr std::array kLeftOut{
    LeftOut{"IfcFurnishingElement", "furniture is moved"},
    LeftOut{"IfcBuildingElementProxy", "a proxy may be anything, and may be moved"},
    LeftOut{"IfcDistributionElement", "equipment"},
    LeftOut{"IfcTransportElement", "it moves"},
    LeftOut{"IfcElementComponent", "fasteners and reinforcement lie within other things"},
    LeftOut{"IfcGeographicElement", "no part of the building"},
    LeftOut{"IfcCivilElement", "no part of the building"},
    LeftOut{"IfcElement", "nothing is known about its class"},
};

/// "opal:Wall" of "IfcWall".
std::string type_of(const std::string& class_name) { return "opal:" + class_name.substr(3); }

Treatment treatment_of(const std::string& class_name, const std::string& word) {
  if (word == "leave_out") return {Kind::left_out, "", "the option classes leaves out " + class_name};
  if (word == "glass") return {Kind::glass, type_of(class_name), "the option classes calls " + class_name + " glass"};
  if (word == "door" || word == "window") return {Kind::filling, word == "door" ? "opal:Door" : "opal:Window", ""};
  if (!word.empty() && word.front() >= 'A' && word.front() <= 'Z' && word.find(':') == std::string::npos)
    return {Kind::solid, "opal:" + word, ""};
  if (word.find(':') == std::string::npos)
    throw MapError("option classes: " + class_name + ": \"" + word +
                   "\", expected a type (\"Wall\", \"acme:Shelf\"), \"glass\", \"door\", \"window\" or \"leave_out\"");
  return {Kind::solid, word, ""};
}

const Treatment* find(const std::map<std::string, Treatment>& treatments, const Element& element) {
  for (const std::string& class_name : element.classes)
    if (const auto found = treatments.find(class_name); found != treatments.end()) return &found->second;
  return nullptr;
}

}  // namespace

Classes::Classes(const std::map<std::string, std::string>& overrides) {
  for (const char* name : kSolid) by_class_[name] = {Kind::solid, type_of(name), ""};
  for (const LeftOut& left_out : kLeftOut) by_class_[left_out.name] = {Kind::left_out, "", left_out.reason};
  by_class_["IfcDoor"] = {Kind::filling, "opal:Door", ""};
  by_class_["IfcWindow"] = {Kind::filling, "opal:Window", ""};
  for (const auto& [class_name, word] : overrides) {
    if (!class_name.starts_with("Ifc"))
      throw MapError("option classes: \"" + class_name + "\", expected the name of an IFC class, such as IfcFurniture");
    overrides_[class_name] = treatment_of(class_name, word);
  }
}

Treatment Classes::of(const Element& element) const {
  if (const Treatment* chosen = find(overrides_, element)) return *chosen;
  Treatment usual = *find(by_class_, element);
  const bool is_nameless = element.words.empty() && element.materials.empty();
  if (element.is_a("IfcPlate") && (is_nameless || is_glass(element)))
    usual = {Kind::glass, usual.type, "glass"};
  else if (usual.kind == Kind::solid && is_glass(element) && !element.is_a("IfcMember"))
    usual = {Kind::glass, usual.type, "glass, by its name or material"};
  return usual;
}

}  // namespace opal::ifc_importer
