#pragma once

// Part of ifc_model.cpp: solids of representation items.

#include "advanced_faces.hpp"
#include "profiles.hpp"

#include <ifcpp/IFC4/include/IfcAdvancedBrepWithVoids.h>
#include <ifcpp/IFC4/include/IfcBlock.h>
#include <ifcpp/IFC4/include/IfcBooleanOperand.h>
#include <ifcpp/IFC4/include/IfcBooleanOperator.h>
#include <ifcpp/IFC4/include/IfcCsgSolid.h>
#include <ifcpp/IFC4/include/IfcExtrudedAreaSolid.h>
#include <ifcpp/IFC4/include/IfcExtrudedAreaSolidTapered.h>
#include <ifcpp/IFC4/include/IfcFacetedBrep.h>
#include <ifcpp/IFC4/include/IfcFacetedBrepWithVoids.h>
#include <ifcpp/IFC4/include/IfcHalfSpaceSolid.h>
#include <ifcpp/IFC4/include/IfcIndexedPolygonalFace.h>
#include <ifcpp/IFC4/include/IfcIndexedPolygonalFaceWithVoids.h>
#include <ifcpp/IFC4/include/IfcPolygonalBoundedHalfSpace.h>
#include <ifcpp/IFC4/include/IfcPolygonalFaceSet.h>
#include <ifcpp/IFC4/include/IfcRevolvedAreaSolid.h>
#include <ifcpp/IFC4/include/IfcRightCircularCylinder.h>
#include <ifcpp/IFC4/include/IfcSweptDiskSolid.h>
#include <ifcpp/IFC4/include/IfcTriangulatedFaceSet.h>
#include <ifcpp/geometry/Carve/RepresentationConverter.h>

namespace opal::ifc_importer::ifcpp {

// A model that repeats its parts without end must not take all memory.
constexpr std::size_t kMaxPoints = 20'000'000;
constexpr double kFarthest_m = 1e6;
// How far an infinite prism is drawn out.
constexpr double kPrism_m = 1000;

class Bodies {
 public:
  Bodies(const shared_ptr<UnitConverter>& units, double unit_m, IndexedCurves indexed)
      : unit_m_(unit_m),
        settings_(std::make_shared<GeometrySettings>()),
        converter_(settings_, units),
        profiles_(converter_, Curves(unit_m, angle_rad(*units), std::move(indexed)), unit_m) {
    settings_->setNumVerticesPerCircle(kFacetsPerCircle);
    carve::setEpsilon(1.5e-05 * unit_m);
  }

  /// Solids of an item that is no mapped one; `T` takes its coordinates to the building's.
  Body of(const shared_ptr<BuildingObject>& item, const Transform3& T) {
    if (const auto result = as<IfcBooleanResult>(item)) return of_boolean(*result, T);
    if (const auto solid = as<IfcCsgSolid>(item)) return of(solid->m_TreeRootExpression, T);
    if (const auto space = as<IfcHalfSpaceSolid>(item)) return of_half_space(*space, T);
    if (const auto brep = as<IfcManifoldSolidBrep>(item)) return of_brep(brep, T);
    if (const auto model = as<IfcFaceBasedSurfaceModel>(item)) return of_face_sets(model->m_FbsmFaces, T);
    if (const auto model = as<IfcShellBasedSurfaceModel>(item)) return of_face_sets(model->m_SbsmBoundary, T);
    if (const auto set = as<IfcTriangulatedFaceSet>(item)) return of_triangles(*set, T);
    if (const auto set = as<IfcPolygonalFaceSet>(item)) return of_polygons(*set, T);
    if (const auto extruded = as<IfcExtrudedAreaSolid>(item)) return of_extrusion(*extruded, T);
    if (const auto block = as<IfcBlock>(item)) return of_block(*block, T);
    if (const auto cylinder = as<IfcRightCircularCylinder>(item)) return of_cylinder(*cylinder, T);
    if (const auto revolved = as<IfcRevolvedAreaSolid>(item)) profiles_.straighten(revolved->m_SweptArea);
    if (const auto pipe = as<IfcSweptDiskSolid>(item)) pipe->m_Directrix = profiles_.straightened(pipe->m_Directrix);
    return of_converted(item, T);
  }

  /// The points of a curve, in the building's coordinates.
  std::vector<Point3> curve(const shared_ptr<IfcCurve>& curve, const Transform3& T) {
    std::vector<Point3> points = profiles_.curves().points(curve);
    for (Point3& p : points) p = checked(T * p);
    return points;
  }

  /// The first point that was refused since it lies too far away [m].
  const std::optional<Point>& first_far_m() const { return first_far_; }

 private:
  /// As the model assigns it; radians if it assigns none.
  static double angle_rad(UnitConverter& units) {
    return units.getAngularUnit() == UnitConverter::UNDEFINED ? 1 : units.getAngleInRadiantFactor();
  }

  Point3 checked(const Point3& point) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > kFarthest_m) {
      if (point.allFinite() && !first_far_) first_far_ = point.head<2>();
      throw Unreadable("has a point farther than 1000 km from the origin (options origin_x_m, origin_y_m), or none");
    }
    if (++points_ > kMaxPoints) throw Unreadable("is left out: the model has more than 20 million points");
    return point;
  }

  Body of_boolean(const IfcBooleanResult& result, const Transform3& T) {
    if (!result.m_Operator) throw Unreadable("a boolean result without operator");
    Body body;
    const auto op = result.m_Operator->m_enum;
    body.kind = op == IfcBooleanOperator::ENUM_UNION          ? Body::Kind::unite
                : op == IfcBooleanOperator::ENUM_INTERSECTION ? Body::Kind::intersect
                                                              : Body::Kind::subtract;
    body.operands = {of(result.m_FirstOperand, T), of(result.m_SecondOperand, T)};
    return body;
  }

  Body of_half_space(const IfcHalfSpaceSolid& space, const Transform3& T) {
    const auto plane = as<IfcPlane>(space.m_BaseSurface);
    if (!plane) throw Unreadable("a half space whose surface is no plane");
    const Transform3 T_plane = T * transform_of(plane->m_Position, unit_m_);
    Body half;
    half.kind = Body::Kind::half_space;
    half.point = checked(T_plane.translation());
    // AgreementFlag: the normal points away from the material.
    const bool away = !space.m_AgreementFlag || space.m_AgreementFlag->m_value;
    half.outward = (away ? 1.0 : -1.0) * (T_plane.linear().inverse().transpose() * Point3::UnitZ()).normalized();
    const auto* bounded = dynamic_cast<const IfcPolygonalBoundedHalfSpace*>(&space);
    if (!bounded) return half;
    const Transform3 T_prism = T * transform_of(bounded->m_Position, unit_m_);
    Body both;
    both.kind = Body::Kind::intersect;
    both.operands = {std::move(half), prism({profiles_.outline(bounded->m_PolygonalBoundary)}, T_prism,
                                            -kPrism_m * Point3::UnitZ(), 2 * kPrism_m * Point3::UnitZ())};
    return both;
  }

  Body of_extrusion(const IfcExtrudedAreaSolid& solid, const Transform3& T) {
    const double depth_m = unit_m_ * number_of(solid.m_Depth, "depth");
    if (depth_m <= 0) throw Unreadable("an extrusion of no depth");
    const Point3 way = depth_m * direction_of(solid.m_ExtrudedDirection, Point3::UnitZ());
    const Transform3 T_solid = T * transform_of(solid.m_Position, unit_m_);
    const Loops loops = profiles_.loops(solid.m_SweptArea);
    const auto* tapered = dynamic_cast<const IfcExtrudedAreaSolidTapered*>(&solid);
    if (!tapered) return prism(loops, T_solid, Point3::Zero(), way);
    return frustum(loops, profiles_.loops(tapered->m_EndSweptArea), T_solid, Point3::Zero(), way);
  }

  Body of_block(const IfcBlock& block, const Transform3& T) {
    const double x = unit_m_ * number_of(block.m_XLength, "length"), y = unit_m_ * number_of(block.m_YLength, "length"),
                 z = unit_m_ * number_of(block.m_ZLength, "length");
    return prism({{{0, 0}, {x, 0}, {x, y}, {0, y}}}, T * transform_of(block.m_Position, unit_m_), Point3::Zero(),
                 z * Point3::UnitZ());
  }

  Body of_cylinder(const IfcRightCircularCylinder& cylinder, const Transform3& T) {
    const double radius_m = unit_m_ * number_of(cylinder.m_Radius, "radius"),
                 height_m = unit_m_ * number_of(cylinder.m_Height, "height");
    if (!(radius_m > 0)) throw Unreadable("a cylinder without radius");
    std::vector<Point> rim = arc_points({Point::Zero(), radius_m}, 0, 2 * std::numbers::pi, kChordShare * radius_m);
    rim.pop_back();
    return prism({std::move(rim)}, T * transform_of(cylinder.m_Position, unit_m_), Point3::Zero(),
                 height_m * Point3::UnitZ());
  }

  /// From `base` along `way`, both in the profile's frame.
  Body prism(const Loops& loops, const Transform3& T, const Point3& base, const Point3& way) {
    return frustum(loops, loops, T, base, way);
  }

  /// From one profile to another, corner to corner.
  Body frustum(const Loops& lower, const Loops& upper, const Transform3& T, const Point3& base, const Point3& way) {
    Shell shell;
    FaceLoops bottom, top;
    if (lower.size() != upper.size()) throw Unreadable("a tapered extrusion between profiles that do not match");
    for (std::size_t loop = 0; loop < lower.size(); ++loop) {
      const std::size_t corners = lower[loop].size();
      if (corners != upper[loop].size()) throw Unreadable("a tapered extrusion between profiles that do not match");
      if (corners < 3) continue;
      bottom.emplace_back();
      top.emplace_back();
      for (std::size_t k = 0; k < corners; ++k) {
        const Point &low = lower[loop][k], &high = upper[loop][k];
        bottom.back().push_back(checked(T * Point3(base + Point3(low.x(), low.y(), 0))));
        top.back().push_back(checked(T * Point3(base + way + Point3(high.x(), high.y(), 0))));
      }
      for (std::size_t k = 0; k < corners; ++k) {
        const std::size_t next = (k + 1) % corners;
        shell.push_back({{bottom.back()[k], bottom.back()[next], top.back()[next], top.back()[k]}});
      }
    }
    if (shell.empty()) throw Unreadable("an outline of less than three points");
    shell.push_back(std::move(bottom));
    shell.push_back(std::move(top));
    return {Body::Kind::shells, {std::move(shell)}};
  }

  Shell shell_of(const std::vector<shared_ptr<IfcFace>>& faces, const Transform3& T) {
    Shell shell;
    for (const auto& face : faces) {
      if (!face) continue;
      for (FaceLoops& facet : AdvancedFaces(profiles_.curves(), unit_m_).facets(*face)) {
        for (auto& loop : facet)
          for (Point3& p : loop) p = checked(T * p);
        shell.push_back(std::move(facet));
      }
    }
    return shell;
  }

  Body of_brep(const shared_ptr<IfcManifoldSolidBrep>& brep, const Transform3& T) {
    if (!brep->m_Outer) throw Unreadable("a brep without outer shell");
    Body outer{Body::Kind::shells, {shell_of(brep->m_Outer->m_CfsFaces, T)}};
    const auto faceted = as<IfcFacetedBrepWithVoids>(brep);
    const auto advanced = as<IfcAdvancedBrepWithVoids>(brep);
    if (!faceted && !advanced) return outer;
    Body body;
    body.kind = Body::Kind::subtract;
    body.operands = {std::move(outer), of_face_sets(faceted ? faceted->m_Voids : advanced->m_Voids, T)};
    return body;
  }

  template <class Set>
  Body of_face_sets(const std::vector<shared_ptr<Set>>& sets, const Transform3& T) {
    Body body;
    for (const auto& set : sets)
      if (const auto faces = as<IfcConnectedFaceSet>(set)) body.shells.push_back(shell_of(faces->m_CfsFaces, T));
    return body;
  }

  std::vector<Point3> listed_points(const IfcTessellatedFaceSet& set, const Transform3& T) {
    if (!set.m_Coordinates) throw Unreadable("a face set without points");
    std::vector<Point3> points;
    for (const auto& triple : set.m_Coordinates->m_CoordList)
      points.push_back(checked(T * Point3(unit_m_ * coordinates(triple, "a point"))));
    return points;
  }

  /// The points as the faces number them: some lists are numbered anew.
  template <class Set>
  std::vector<Point3> numbered_points(const Set& set, const Transform3& T) {
    const std::vector<Point3> points = listed_points(set, T);
    return set.m_PnIndex.empty() ? points : picked(points, set.m_PnIndex);
  }

  template <class Indices>
  static std::vector<Point3> picked(const std::vector<Point3>& points, const Indices& indices) {
    std::vector<Point3> loop;
    for (const auto& index : indices) {
      if (!index || index->m_value < 1 || static_cast<std::size_t>(index->m_value) > points.size())
        throw Unreadable("a face set that names a point which it does not have");
      loop.push_back(points[static_cast<std::size_t>(index->m_value) - 1]);
    }
    return loop;
  }

  Body of_triangles(const IfcTriangulatedFaceSet& set, const Transform3& T) {
    const std::vector<Point3> points = numbered_points(set, T);
    Shell shell;
    for (const auto& triangle : set.m_CoordIndex) shell.push_back({picked(points, triangle)});
    return {Body::Kind::shells, {std::move(shell)}};
  }

  Body of_polygons(const IfcPolygonalFaceSet& set, const Transform3& T) {
    const std::vector<Point3> points = numbered_points(set, T);
    Shell shell;
    for (const auto& face : set.m_Faces) {
      if (!face) continue;
      shell.push_back({picked(points, face->m_CoordIndex)});
      if (const auto with_voids = as<IfcIndexedPolygonalFaceWithVoids>(face))
        for (const auto& inner : with_voids->m_InnerCoordIndices) shell.back().push_back(picked(points, inner));
    }
    return {Body::Kind::shells, {std::move(shell)}};
  }

  /// What is left to the library: revolved and swept solids, primitives.
  Body of_converted(const shared_ptr<BuildingObject>& item, const Transform3& T) {
    const auto geometry = as<IfcGeometricRepresentationItem>(item);
    if (!geometry) throw Unreadable(item ? std::string(item->className()) + " is no solid" : "an item is missing");
    const auto data = std::make_shared<ItemShapeData>();
    converter_.convertIfcGeometricRepresentationItem(geometry, data);
    Body body;
    for (const auto* sets : {&data->m_meshsets, &data->m_meshsets_open})
      for (const auto& set : *sets)
        for (const auto* mesh : set->meshes) body.shells.push_back(shell_of(*mesh, T));
    if (body.shells.empty()) throw Unreadable(std::string(item->className()) + " gives no solid");
    return body;
  }

  Shell shell_of(const carve::mesh::Mesh<3>& mesh, const Transform3& T) {
    Shell shell;
    for (const auto* face : mesh.faces) {
      std::vector<Point3> loop;
      const auto* edge = face->edge;
      do {
        const auto& p = edge->vert->v;
        loop.push_back(checked(T * Point3(p.x, p.y, p.z)));
        edge = edge->next;
      } while (edge != face->edge);
      shell.push_back({std::move(loop)});
    }
    return shell;
  }

  double unit_m_;
  shared_ptr<GeometrySettings> settings_;
  RepresentationConverter converter_;
  Profiles profiles_;
  std::optional<Point> first_far_;
  std::size_t points_ = 0;
};

}  // namespace opal::ifc_importer::ifcpp
