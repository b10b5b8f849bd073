#pragma once

// Part of ifc_model.cpp: things with their shapes, openings, parts and words.

#include "bodies.hpp"
#include "classes.hpp"

#include <opal/common/letter_case.hpp>

#include <ifcpp/IFC4/include/IfcFeatureElementAddition.h>
#include <ifcpp/IFC4/include/IfcFeatureElementSubtraction.h>
#include <ifcpp/IFC4/include/IfcMaterial.h>
#include <ifcpp/IFC4/include/IfcMaterialConstituent.h>
#include <ifcpp/IFC4/include/IfcMaterialConstituentSet.h>
#include <ifcpp/IFC4/include/IfcMaterialLayer.h>
#include <ifcpp/IFC4/include/IfcMaterialLayerSet.h>
#include <ifcpp/IFC4/include/IfcMaterialLayerSetUsage.h>
#include <ifcpp/IFC4/include/IfcMaterialList.h>
#include <ifcpp/IFC4/include/IfcNonNegativeLengthMeasure.h>
#include <ifcpp/IFC4/include/IfcOpeningElement.h>
#include <ifcpp/IFC4/include/IfcRelAggregates.h>
#include <ifcpp/IFC4/include/IfcRelAssociatesMaterial.h>
#include <ifcpp/IFC4/include/IfcRelContainedInSpatialStructure.h>
#include <ifcpp/IFC4/include/IfcRelDefinesByType.h>
#include <ifcpp/IFC4/include/IfcRelFillsElement.h>
#include <ifcpp/IFC4/include/IfcRelProjectsElement.h>
#include <ifcpp/IFC4/include/IfcRelVoidsElement.h>
#include <ifcpp/IFC4/include/IfcSpatialElement.h>
#include <ifcpp/IFC4/include/IfcText.h>
#include <ifcpp/IFC4/include/IfcTypeObject.h>

#include <algorithm>
#include <array>

namespace opal::ifc_importer::ifcpp {

/// Representations that are no solids, or solids that stand for something else.
inline bool is_no_body(const std::string& identifier) {
  static constexpr std::array kOthers{"Axis",          "Box",      "FootPrint",   "Annotation",   "Profile",
                                      "Clearance",     "Lighting", "Plan",        "Reference",    "CoG",
                                      "Body-FallBack", "Surface",  "FootPrint2D", "Survey Points"};
  return std::find(kOthers.begin(), kOthers.end(), identifier) != kOthers.end();
}

class Elements {
 public:
  Elements(Bodies& bodies, double unit_m, const Point& origin_m)
      : bodies_(bodies), placements_(unit_m, origin_m), unit_m_(unit_m) {}

  Element read(const IfcElement& element) {
    Element read;
    read.id = text_of(element.m_GlobalId);
    read.classes = classes_of(element);
    read.name = text_of(element.m_Name);
    read.whole = whole_of(element);
    read.storey = storey_of(element, 0);
    read_words(element, read);
    for (const auto& fills : element.m_FillsVoids_inverse)
      if (const auto relation = locked(fills); relation && relation->m_RelatingOpeningElement)
        read.fills = text_of(relation->m_RelatingOpeningElement->m_GlobalId);
    read_shape(element, read.bodies, read.troubles, &read);
    for (const auto& projects : element.m_HasProjections_inverse)
      if (const auto relation = locked(projects); relation && relation->m_RelatedFeatureElement)
        read_shape(*relation->m_RelatedFeatureElement, read.bodies, read.troubles, nullptr);
    for (const auto& voids : element.m_HasOpenings_inverse)
      if (const auto relation = locked(voids); relation && relation->m_RelatedOpeningElement) {
        const auto& opening = *relation->m_RelatedOpeningElement;
        read.openings.push_back({text_of(opening.m_GlobalId), {}});
        read_shape(opening, read.openings.back().bodies, read.troubles, nullptr);
      }
    return read;
  }

  /// Height of a product's own origin [m]; none if it has no placement that can be computed.
  std::optional<double> height_of(const IfcProduct& product) const {
    if (!product.m_ObjectPlacement) return std::nullopt;
    try {
      return placements_.of(product.m_ObjectPlacement).translation().z();
    } catch (const Unreadable&) {
      return std::nullopt;
    }
  }

 private:
  static std::string whole_of(const IfcObjectDefinition& part) {
    for (const auto& relation : part.m_Decomposes_inverse)
      if (const auto aggregates = locked(relation))
        if (const auto whole = as<IfcElement>(aggregates->m_RelatingObject)) return text_of(whole->m_GlobalId);
    return "";
  }

  std::string storey_of(const IfcElement& element, int depth) const {
    for (const auto& contained : element.m_ContainedInStructure_inverse)
      if (const auto relation = locked(contained); relation && relation->m_RelatingStructure)
        return text_of(relation->m_RelatingStructure->m_Name);
    for (const auto& relation : element.m_Decomposes_inverse)
      if (const auto aggregates = locked(relation); aggregates && depth < 10)
        if (const auto whole = as<IfcElement>(aggregates->m_RelatingObject)) return storey_of(*whole, depth + 1);
    return "";
  }

  void read_words(const IfcElement& element, Element& read) const {
    const auto add = [&read](const auto& label) {
      if (label && !label->m_value.empty()) read.words.push_back(lower_case_letters(text_of(label)));
    };
    add(element.m_Name);
    add(element.m_ObjectType);
    for (const auto& typed : element.m_IsTypedBy_inverse)
      if (const auto relation = locked(typed); relation && relation->m_RelatingType)
        add(relation->m_RelatingType->m_Name);
    for (const auto& association : element.m_HasAssociations_inverse)
      if (const auto relation = as<IfcRelAssociatesMaterial>(locked(association)))
        read_material(relation->m_RelatingMaterial, read);
  }

  void read_material(const shared_ptr<IfcMaterialSelect>& select, Element& read) const {
    const auto add = [&read](const shared_ptr<IfcMaterial>& material, double thickness_m = 0) {
      if (material && material->m_Name)
        read.materials.push_back({lower_case_letters(text_of(material->m_Name)), thickness_m});
    };
    add(as<IfcMaterial>(select));
    if (const auto list = as<IfcMaterialList>(select))
      for (const auto& material : list->m_Materials) add(material);
    if (const auto set = as<IfcMaterialConstituentSet>(select))
      for (const auto& part : set->m_MaterialConstituents)
        if (part) add(part->m_Material);
    const auto usage = as<IfcMaterialLayerSetUsage>(select);
    const auto layers = usage ? usage->m_ForLayerSet : as<IfcMaterialLayerSet>(select);
    if (!layers) return;
    double thickness_m = 0;
    for (const auto& layer : layers->m_MaterialLayers)
      if (layer) {
        const double layer_m = layer->m_LayerThickness ? unit_m_ * layer->m_LayerThickness->m_value : 0;
        add(layer->m_Material, layer_m > 0 && layer_m < 100 ? layer_m : 0);
        thickness_m += layer_m;
      }
    if (thickness_m > 0 && thickness_m < 100) read.thickness_m = thickness_m;
  }

  /// @param axis_of  gets the axis and the direction of the product; null: nobody wants them.
  void read_shape(const IfcProduct& product, std::vector<Body>& bodies, std::vector<std::string>& troubles,
                  Element* axis_of) {
    if (!product.m_Representation) return;
    try {
      const Transform3 T = placements_.of(product.m_ObjectPlacement);
      if (axis_of) set_direction(T, *axis_of);
      for (const auto& representation : product.m_Representation->m_Representations) {
        if (!representation) continue;
        const std::string identifier = text_of(representation->m_RepresentationIdentifier);
        if (identifier == "Axis" && axis_of) read_axis(*representation, T, *axis_of);
        if (!is_no_body(identifier)) read_items(*representation, T, bodies, troubles, 0);
      }
    } catch (const Unreadable& trouble) {
      troubles.push_back(trouble.what());
    }
  }

  static void set_direction(const Transform3& T, Element& element) {
    const Point along = T.linear().col(0).head<2>();
    if (along.norm() > 1e-6) element.along = along.normalized();
  }

  void read_axis(const IfcRepresentation& representation, const Transform3& T, Element& element) {
    const auto curve = representation.m_Items.size() == 1 ? as<IfcCurve>(representation.m_Items.front()) : nullptr;
    if (!curve) return;
    attempt(element.troubles, [&] {
      const std::vector<Point3> points = bodies_.curve(curve, T);
      if (points.size() < 2 || (points.back() - points.front()).head<2>().norm() < 1e-3) return;
      const Segment chord{points.front().head<2>(), points.back().head<2>()};
      const bool is_straight = std::all_of(points.begin(), points.end(), [&](const Point3& p) {
        return std::abs(cross(chord.direction(), p.head<2>() - chord.begin)) < 1e-3;
      });
      if (is_straight) element.axis = chord;
    });
  }

  void read_items(const IfcRepresentation& representation, const Transform3& T, std::vector<Body>& bodies,
                  std::vector<std::string>& troubles, int depth) {
    for (const auto& item : representation.m_Items) {
      if (!item || is_flat(*item)) continue;
      attempt(troubles, [&] {
        if (const auto mapped = as<IfcMappedItem>(item))
          read_mapped(*mapped, T, bodies, troubles, depth);
        else
          bodies.push_back(bodies_.of(item, T));
      });
    }
  }

  void read_mapped(const IfcMappedItem& mapped, const Transform3& T, std::vector<Body>& bodies,
                   std::vector<std::string>& troubles, int depth) {
    const auto& source = mapped.m_MappingSource;
    if (!source || !source->m_MappedRepresentation) throw Unreadable("a mapped item without a source");
    if (depth > 20 || ++mapped_items_ > 1'000'000) throw Unreadable("mapped items within mapped items without an end");
    if (is_no_body(text_of(source->m_MappedRepresentation->m_RepresentationIdentifier))) return;
    const Transform3 T_item =
        T * transform_of(mapped.m_MappingTarget, unit_m_) * transform_of(source->m_MappingOrigin, unit_m_);
    read_items(*source->m_MappedRepresentation, T_item, bodies, troubles, depth + 1);
  }

  /// Lines and texts have no body, and none is missed.
  static bool is_flat(const IfcRepresentationItem& item) {
    const auto is_line = [](const auto& member) { return !member || as<IfcCurve>(member) || as<IfcPoint>(member); };
    if (const auto* set = dynamic_cast<const IfcGeometricSet*>(&item))
      return std::all_of(set->m_Elements.begin(), set->m_Elements.end(), is_line);
    return is<IfcCurve>(item) || is<IfcPoint>(item) || is<IfcTextLiteral>(item) || is<IfcAnnotationFillArea>(item);
  }

  /// What the library throws becomes a trouble of the thing.
  template <class Act>
  static void attempt(std::vector<std::string>& troubles, Act act) {
    try {
      act();
    } catch (const carve::exception& trouble) {
      troubles.push_back(trouble.str());
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& trouble) {
      troubles.push_back(trouble.what());
    }
  }

  Bodies& bodies_;
  Placements placements_;
  double unit_m_;
  std::size_t mapped_items_ = 0;
};

}  // namespace opal::ifc_importer::ifcpp
