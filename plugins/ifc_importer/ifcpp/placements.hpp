#pragma once

// Part of ifc_model.cpp: where things are.

#include "values.hpp"

#include <ifcpp/IFC4/include/IfcAxis2Placement2D.h>
#include <ifcpp/IFC4/include/IfcAxis2Placement3D.h>
#include <ifcpp/IFC4/include/IfcBoolean.h>
#include <ifcpp/IFC4/include/IfcCartesianTransformationOperator2D.h>
#include <ifcpp/IFC4/include/IfcCartesianTransformationOperator2DnonUniform.h>
#include <ifcpp/IFC4/include/IfcCartesianTransformationOperator3D.h>
#include <ifcpp/IFC4/include/IfcCartesianTransformationOperator3DnonUniform.h>
#include <ifcpp/IFC4/include/IfcGrid.h>
#include <ifcpp/IFC4/include/IfcGridAxis.h>
#include <ifcpp/IFC4/include/IfcGridPlacement.h>
#include <ifcpp/IFC4/include/IfcLocalPlacement.h>
#include <ifcpp/IFC4/include/IfcPolyline.h>
#include <ifcpp/IFC4/include/IfcVirtualGridIntersection.h>

namespace opal::ifc_importer::ifcpp {

inline Transform3 frame(const Point3& origin, const Point3& x, const Point3& y, const Point3& z) {
  Transform3 T = Transform3::Identity();
  T.linear().col(0) = x;
  T.linear().col(1) = y;
  T.linear().col(2) = z;
  T.translation() = origin;
  return T;
}

/// Right-handed axes: z as it is, x as near to `towards` as it can be.
inline Transform3 frame(const Point3& origin, const Point3& z, const Point3& towards) {
  Point3 x = towards - towards.dot(z) * z;
  if (x.norm() < 1e-9) x = z.unitOrthogonal();
  x.normalize();
  return frame(origin, x, z.cross(x), z);
}

inline Transform3 transform_of(const shared_ptr<IfcAxis2Placement3D>& placement, double unit_m) {
  if (!placement) return Transform3::Identity();
  return frame(point_of(placement->m_Location, unit_m), direction_of(placement->m_Axis, Point3::UnitZ()),
               direction_of(placement->m_RefDirection, Point3::UnitX()));
}

inline Transform3 transform_of(const shared_ptr<IfcAxis2Placement2D>& placement, double unit_m) {
  if (!placement) return Transform3::Identity();
  return frame(point_of(placement->m_Location, unit_m), Point3::UnitZ(),
               direction_of(placement->m_RefDirection, Point3::UnitX()));
}

inline Transform3 transform_of(const shared_ptr<IfcAxis2Placement>& placement, double unit_m) {
  if (const auto in_space = as<IfcAxis2Placement3D>(placement)) return transform_of(in_space, unit_m);
  return transform_of(as<IfcAxis2Placement2D>(placement), unit_m);
}

/// Of a mapped item: turned, moved, scaled, perhaps mirrored.
inline Transform3 transform_of(const shared_ptr<IfcCartesianTransformationOperator>& target, double unit_m) {
  if (!target) return Transform3::Identity();
  const auto in_space = as<IfcCartesianTransformationOperator3D>(target);
  const Point3 z = in_space ? direction_of(in_space->m_Axis3, Point3::UnitZ()) : Point3::UnitZ();
  Transform3 T = frame(point_of(target->m_LocalOrigin, unit_m), z, direction_of(target->m_Axis1, Point3::UnitX()));
  if (target->m_Axis2 && T.linear().col(1).dot(direction_of(target->m_Axis2, Point3::UnitY())) < 0)
    T.linear().col(1) *= -1;
  Point3 scale = Point3::Constant(target->m_Scale ? number_of(target->m_Scale, "scale") : 1);
  if (const auto uneven = as<IfcCartesianTransformationOperator3DnonUniform>(target)) {
    if (uneven->m_Scale2) scale.y() = number_of(uneven->m_Scale2, "scale");
    if (uneven->m_Scale3) scale.z() = number_of(uneven->m_Scale3, "scale");
  }
  if (const auto uneven = as<IfcCartesianTransformationOperator2DnonUniform>(target))
    if (uneven->m_Scale2) scale.y() = number_of(uneven->m_Scale2, "scale");
  T.linear() *= scale.asDiagonal();
  return T;
}

/// A straight grid axis, in the grid's coordinates.
struct AxisLine {
  Point3 through, direction;
};

inline AxisLine line_of(const shared_ptr<IfcGridAxis>& axis, double unit_m) {
  const auto curve = axis ? as<IfcPolyline>(axis->m_AxisCurve) : nullptr;
  if (!curve || curve->m_Points.size() != 2)
    throw Unreadable("stands on a grid axis that is no straight line, which is not computed");
  AxisLine line{point_of(curve->m_Points[0], unit_m), point_of(curve->m_Points[1], unit_m)};
  line.direction = line.direction - line.through;
  if (line.direction.norm() < 1e-9) throw Unreadable("stands on a grid axis without length");
  line.direction.normalize();
  if (axis->m_SameSense && !axis->m_SameSense->m_value) line.direction *= -1;
  return line;
}

/// Where two grid axes meet, each moved to its left by its offset, and the direction of the first.
inline AxisLine meeting_of(const shared_ptr<IfcVirtualGridIntersection>& meeting, double unit_m) {
  if (!meeting || meeting->m_IntersectingAxes.size() != 2) throw Unreadable("stands on no crossing of two grid axes");
  AxisLine lines[2];
  for (std::size_t k = 0; k < 2; ++k) {
    lines[k] = line_of(meeting->m_IntersectingAxes[k], unit_m);
    const double offset_m =
        k < meeting->m_OffsetDistances.size() ? unit_m * number_of(meeting->m_OffsetDistances[k], "an offset") : 0;
    lines[k].through += offset_m * Point3::UnitZ().cross(lines[k].direction);
  }
  const double sine = lines[0].direction.cross(lines[1].direction).z();
  if (std::abs(sine) < 1e-6) throw Unreadable("stands on grid axes that do not cross");
  const double along = (lines[1].through - lines[0].through).cross(lines[1].direction).z() / sine;
  Point3 place = lines[0].through + along * lines[0].direction;
  if (meeting->m_OffsetDistances.size() > 2)
    place.z() += unit_m * number_of(meeting->m_OffsetDistances[2], "an offset");
  return {place, lines[0].direction};
}

class Placements {
 public:
  /// @param origin_m  what lies here in the model is at (0, 0) in the map.
  Placements(double unit_m, const Point& origin_m) : unit_m_(unit_m) { T_map_model_.translation() << -origin_m, 0; }

  /// T_map_object.
  Transform3 of(const shared_ptr<IfcObjectPlacement>& placement) const {
    if (!placement) return T_map_model_;
    if (const auto local = as<IfcLocalPlacement>(placement))
      return of(local->m_PlacementRelTo) * transform_of(local->m_RelativePlacement, unit_m_);
    if (const auto grid = as<IfcGridPlacement>(placement)) return on_grid(*grid);
    throw Unreadable(std::string("has a placement of the kind ") + placement->className() + ", which is not computed");
  }

 private:
  Transform3 on_grid(const IfcGridPlacement& placement) const {
    const AxisLine place = meeting_of(placement.m_PlacementLocation, unit_m_);
    Point3 x = place.direction;
    if (const auto direction = as<IfcDirection>(placement.m_PlacementRefDirection)) x = direction_of(direction, x);
    if (const auto other = as<IfcVirtualGridIntersection>(placement.m_PlacementRefDirection))
      x = meeting_of(other, unit_m_).through - place.through;
    return of_grid(*placement.m_PlacementLocation) * frame(place.through, Point3::UnitZ(), x);
  }

  Transform3 of_grid(const IfcVirtualGridIntersection& meeting) const {
    for (const auto& axis : meeting.m_IntersectingAxes)
      for (const auto* grids : {&axis->m_PartOfU_inverse, &axis->m_PartOfV_inverse, &axis->m_PartOfW_inverse})
        for (const auto& grid : *grids)
          if (const auto found = locked(grid)) return of(found->m_ObjectPlacement);
    throw Unreadable("stands on axes that belong to no grid");
  }

  double unit_m_;
  Transform3 T_map_model_ = Transform3::Identity();
};

}  // namespace opal::ifc_importer::ifcpp
