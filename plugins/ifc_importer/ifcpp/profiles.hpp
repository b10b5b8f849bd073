#pragma once

// Part of ifc_model.cpp: outlines of profiles.

#include "curves.hpp"

#include <ifcpp/IFC4/include/IfcArbitraryClosedProfileDef.h>
#include <ifcpp/IFC4/include/IfcArbitraryOpenProfileDef.h>
#include <ifcpp/IFC4/include/IfcArbitraryProfileDefWithVoids.h>
#include <ifcpp/IFC4/include/IfcAsymmetricIShapeProfileDef.h>
#include <ifcpp/IFC4/include/IfcCompositeProfileDef.h>
#include <ifcpp/IFC4/include/IfcDerivedProfileDef.h>
#include <ifcpp/IFC4/include/IfcMirroredProfileDef.h>
#include <ifcpp/geometry/Carve/RepresentationConverter.h>

namespace opal::ifc_importer::ifcpp {

// Facets of a full circle: 0.1 % of the radius off at the middle of each.
constexpr int kFacetsPerCircle = 72;

/// Closed lines; what lies in an odd number of them is solid.
using Loops = std::vector<std::vector<Point>>;

class Profiles {
 public:
  Profiles(RepresentationConverter& converter, Curves curves, double unit_m)
      : converter_(converter), curves_(std::move(curves)), unit_m_(unit_m) {}

  const Curves& curves() const { return curves_; }

  /// In the profile's frame [m]. @throws Unreadable for profiles that enclose nothing.
  Loops loops(const shared_ptr<IfcProfileDef>& profile, int depth = 0) const {
    if (!profile) throw Unreadable("a solid without profile");
    if (depth > kCurvesInCurves) throw Unreadable("profiles within profiles without an end");
    if (const auto closed = as<IfcArbitraryClosedProfileDef>(profile)) return of_curves(*closed);
    if (const auto derived = as<IfcDerivedProfileDef>(profile)) return of_derived(*derived, depth);
    if (const auto several = as<IfcCompositeProfileDef>(profile)) return of_several(*several, depth);
    if (const auto section = as<IfcAsymmetricIShapeProfileDef>(profile)) return of_asymmetric_i(*section);
    if (as<IfcArbitraryOpenProfileDef>(profile))
      throw Unreadable(std::string(profile->className()) + ": open profiles are not computed");
    return of_parameters(profile);
  }

  std::vector<Point> outline(const shared_ptr<IfcCurve>& curve) const {
    std::vector<Point> loop;
    for (const Point3& p : curves_.points(curve))
      if (loop.empty() || (p.head<2>() - loop.back()).norm() > 1e-9) loop.push_back(p.head<2>());
    while (loop.size() > 1 && (loop.front() - loop.back()).norm() < 1e-6) loop.pop_back();
    return loop;
  }

  /// The same curve of straight pieces, in the model's unit: the library understands these only.
  shared_ptr<IfcCurve> straightened(const shared_ptr<IfcCurve>& curve) const {
    const auto line = std::make_shared<IfcPolyline>();
    for (const Point3& p : curves_.points(curve)) {
      const auto point = std::make_shared<IfcCartesianPoint>();
      for (const double value : {p.x(), p.y(), p.z()})
        point->m_Coordinates.push_back(std::make_shared<IfcLengthMeasure>(value / unit_m_));
      line->m_Points.push_back(point);
    }
    return line;
  }

  void straighten(const shared_ptr<IfcProfileDef>& profile) const {
    if (const auto closed = as<IfcArbitraryClosedProfileDef>(profile))
      closed->m_OuterCurve = straightened(closed->m_OuterCurve);
    if (const auto with_voids = as<IfcArbitraryProfileDefWithVoids>(profile))
      for (auto& inner : with_voids->m_InnerCurves) inner = straightened(inner);
  }

 private:
  Loops of_curves(const IfcArbitraryClosedProfileDef& profile) const {
    Loops loops{outline(profile.m_OuterCurve)};
    if (const auto* with_voids = dynamic_cast<const IfcArbitraryProfileDefWithVoids*>(&profile))
      for (const auto& inner : with_voids->m_InnerCurves) loops.push_back(outline(inner));
    return loops;
  }

  Loops of_derived(const IfcDerivedProfileDef& profile, int depth) const {
    Transform3 T = transform_of(profile.m_Operator, unit_m_);
    if (dynamic_cast<const IfcMirroredProfileDef*>(&profile)) T.linear().col(0) *= -1;
    Loops loops = this->loops(profile.m_ParentProfile, depth + 1);
    for (auto& loop : loops)
      for (Point& p : loop) p = (T * Point3(p.x(), p.y(), 0)).head<2>();
    return loops;
  }

  Loops of_several(const IfcCompositeProfileDef& profile, int depth) const {
    Loops all;
    for (const auto& part : profile.m_Profiles)
      for (auto& loop : loops(part, depth + 1)) all.push_back(std::move(loop));
    return all;
  }

  /// Without fillets and slopes, which the library does not have either. The library gives no outline of it.
  Loops of_asymmetric_i(const IfcAsymmetricIShapeProfileDef& profile) const {
    const double below = unit_m_ * number_of(profile.m_BottomFlangeWidth, "BottomFlangeWidth") / 2;
    const double above = unit_m_ * number_of(profile.m_TopFlangeWidth, "TopFlangeWidth") / 2;
    const double web = unit_m_ * number_of(profile.m_WebThickness, "WebThickness") / 2;
    const double half = unit_m_ * number_of(profile.m_OverallDepth, "OverallDepth") / 2;
    const double bottom_m = unit_m_ * number_of(profile.m_BottomFlangeThickness, "BottomFlangeThickness");
    const double top_m = profile.m_TopFlangeThickness
                             ? unit_m_ * number_of(profile.m_TopFlangeThickness, "TopFlangeThickness")
                             : bottom_m;
    const double low = bottom_m - half, high = half - top_m;
    std::vector<Point> loop{{-below, -half}, {below, -half}, {below, low},   {web, low},   {web, high}, {above, high},
                            {above, half},   {-above, half}, {-above, high}, {-web, high}, {-web, low}, {-below, low}};
    const Transform3 T = transform_of(profile.m_Position, unit_m_);
    for (Point& p : loop) p = (T * Point3(p.x(), p.y(), 0)).head<2>();
    return {loop};
  }

  /// Rectangles, circles, rolled sections: by the library.
  Loops of_parameters(shared_ptr<IfcProfileDef> profile) const {
    const auto converted = converter_.getProfileCache()->getProfileConverter(profile);
    Loops loops;
    for (const std::vector<vec2>& path : converted->getCoordinates()) {
      loops.emplace_back();
      for (const vec2& p : path) loops.back().emplace_back(p.x, p.y);
    }
    if (loops.empty())
      throw Unreadable(std::string("a profile of the kind ") + profile->className() + " without outline");
    return loops;
  }

  RepresentationConverter& converter_;
  Curves curves_;
  double unit_m_;
};

}  // namespace opal::ifc_importer::ifcpp
