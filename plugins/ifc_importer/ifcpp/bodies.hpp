#pragma once

// Part of ifc_model.cpp: solids of representation items.

#include "placements.hpp"

#include <ifcpp/geometry/Carve/RepresentationConverter.h>
#include <ifcpp/IFC4/include/IfcAdvancedBrep.h>
#include <ifcpp/IFC4/include/IfcBooleanOperand.h>
#include <ifcpp/IFC4/include/IfcBooleanOperator.h>
#include <ifcpp/IFC4/include/IfcCartesianPointList3D.h>
#include <ifcpp/IFC4/include/IfcCsgSolid.h>
#include <ifcpp/IFC4/include/IfcExtrudedAreaSolid.h>
#include <ifcpp/IFC4/include/IfcExtrudedAreaSolidTapered.h>
#include <ifcpp/IFC4/include/IfcFaceBound.h>
#include <ifcpp/IFC4/include/IfcFacetedBrep.h>
#include <ifcpp/IFC4/include/IfcFacetedBrepWithVoids.h>
#include <ifcpp/IFC4/include/IfcHalfSpaceSolid.h>
#include <ifcpp/IFC4/include/IfcIndexedPolygonalFace.h>
#include <ifcpp/IFC4/include/IfcIndexedPolygonalFaceWithVoids.h>
#include <ifcpp/IFC4/include/IfcPlane.h>
#include <ifcpp/IFC4/include/IfcPolyLoop.h>
#include <ifcpp/IFC4/include/IfcPolygonalBoundedHalfSpace.h>
#include <ifcpp/IFC4/include/IfcPolygonalFaceSet.h>
#include <ifcpp/IFC4/include/IfcPositiveInteger.h>
#include <ifcpp/IFC4/include/IfcTriangulatedFaceSet.h>

namespace opal::ifc_importer::ifcpp {

// Facets of a full circle: 0.1 % of the radius off at the middle of each.
constexpr int kFacetsPerCircle = 72;
// A model that repeats its parts without end must not take all memory.
constexpr std::size_t kMaxPoints = 20'000'000;
constexpr double kFarthest_m = 1e6;
// How far an infinite prism is drawn out.
constexpr double kPrism_m = 1000;

class Bodies {
 public:
  Bodies(const shared_ptr<UnitConverter>& units, double unit_m)
      : unit_m_(unit_m), settings_(std::make_shared<GeometrySettings>()), converter_(settings_, units) {
    settings_->setNumVerticesPerCircle(kFacetsPerCircle);
    carve::setEpsilon(1.5e-05 * unit_m);
  }

  /// Solids of an item that is no mapped one; `T` takes its coordinates to the building's.
  Body of(const shared_ptr<BuildingObject>& item, const Transform3& T) {
    if (const auto result = as<IfcBooleanResult>(item)) return of_boolean(*result, T);
    if (const auto solid = as<IfcCsgSolid>(item)) return of(solid->m_TreeRootExpression, T);
    if (const auto space = as<IfcHalfSpaceSolid>(item)) return of_half_space(*space, T);
    if (as<IfcAdvancedBrep>(item)) throw Unreadable("IfcAdvancedBrep: curved surfaces are not cut");
    if (const auto brep = as<IfcManifoldSolidBrep>(item)) return of_brep(brep, T);
    if (const auto model = as<IfcFaceBasedSurfaceModel>(item)) return of_face_sets(model->m_FbsmFaces, T);
    if (const auto model = as<IfcShellBasedSurfaceModel>(item)) return of_face_sets(model->m_SbsmBoundary, T);
    if (const auto set = as<IfcTriangulatedFaceSet>(item)) return of_triangles(*set, T);
    if (const auto set = as<IfcPolygonalFaceSet>(item)) return of_polygons(*set, T);
    const auto extruded = as<IfcExtrudedAreaSolid>(item);
    if (extruded && !as<IfcExtrudedAreaSolidTapered>(item)) return of_extrusion(extruded, T);
    return of_converted(item, T);
  }

  /// The points of a curve, in the building's coordinates.
  std::vector<Point3> curve(const shared_ptr<IfcCurve>& curve, const Transform3& T) {
    std::vector<vec3> points, starts;
    converter_.getCurveConverter()->convertIfcCurve(curve, points, starts);
    std::vector<Point3> converted;
    for (const vec3& p : points) converted.push_back(checked(T * Point3(p.x, p.y, p.z)));
    return converted;
  }

 private:
  Point3 checked(const Point3& point) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > kFarthest_m)
      throw Unreadable("has a point farther than 1000 km from the origin, or none");
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
    both.operands = {std::move(half), prism({outline(bounded->m_PolygonalBoundary)}, T_prism, -kPrism_m * Point3::UnitZ(),
                                            2 * kPrism_m * Point3::UnitZ())};
    return both;
  }

  std::vector<Point> outline(const shared_ptr<IfcCurve>& curve) {
    std::vector<vec2> points, starts;
    converter_.getCurveConverter()->convertIfcCurve2D(curve, points, starts);
    std::vector<Point> loop;
    for (const vec2& p : points) loop.emplace_back(p.x, p.y);
    if (loop.size() > 1 && (loop.front() - loop.back()).norm() < 1e-6) loop.pop_back();
    return loop;
  }

  Body of_extrusion(const shared_ptr<IfcExtrudedAreaSolid>& solid, const Transform3& T) {
    if (!solid->m_SweptArea) throw Unreadable("an extrusion without profile");
    const auto profile = converter_.getProfileCache()->getProfileConverter(solid->m_SweptArea);
    std::vector<std::vector<Point>> loops;
    for (const std::vector<vec2>& path : profile->getCoordinates()) {
      loops.emplace_back();
      for (const vec2& p : path) loops.back().emplace_back(p.x, p.y);
    }
    if (loops.empty()) throw Unreadable(std::string("a profile of the kind ") + solid->m_SweptArea->className() + " without outline");
    const double depth_m = unit_m_ * number_of(solid->m_Depth, "depth");
    if (depth_m <= 0) throw Unreadable("an extrusion of no depth");
    return prism(loops, T * transform_of(solid->m_Position, unit_m_), Point3::Zero(),
                 depth_m * direction_of(solid->m_ExtrudedDirection, Point3::UnitZ()));
  }

  /// From `base` along `way`, both in the profile's frame.
  Body prism(const std::vector<std::vector<Point>>& loops, const Transform3& T, const Point3& base, const Point3& way) {
    Shell shell;
    FaceLoops bottom, top;
    for (const std::vector<Point>& loop : loops) {
      if (loop.size() < 3) continue;
      bottom.emplace_back();
      top.emplace_back();
      for (const Point& p : loop) {
        const Point3 low = base + Point3(p.x(), p.y(), 0);
        bottom.back().push_back(checked(T * low));
        top.back().push_back(checked(T * Point3(low + way)));
      }
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const std::size_t next = (k + 1) % loop.size();
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
      FaceLoops loops;
      for (const auto& bound : face->m_Bounds) {
        const auto loop = bound ? as<IfcPolyLoop>(bound->m_Bound) : nullptr;
        if (!loop) throw Unreadable("a face that is not bounded by straight lines");
        loops.emplace_back();
        for (const auto& point : loop->m_Polygon) loops.back().push_back(checked(T * point_of(point, unit_m_)));
      }
      shell.push_back(std::move(loops));
    }
    return shell;
  }

  Body of_brep(const shared_ptr<IfcManifoldSolidBrep>& brep, const Transform3& T) {
    if (!brep->m_Outer) throw Unreadable("a brep without outer shell");
    Body outer{Body::Kind::shells, {shell_of(brep->m_Outer->m_CfsFaces, T)}};
    const auto with_voids = as<IfcFacetedBrepWithVoids>(brep);
    if (!with_voids) return outer;
    Body body;
    body.kind = Body::Kind::subtract;
    body.operands = {std::move(outer), of_face_sets(with_voids->m_Voids, T)};
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
    const std::vector<Point3> points = listed_points(set, T);
    Shell shell;
    for (const auto& triangle : set.m_CoordIndex) shell.push_back({picked(points, triangle)});
    return {Body::Kind::shells, {std::move(shell)}};
  }

  Body of_polygons(const IfcPolygonalFaceSet& set, const Transform3& T) {
    const std::vector<Point3> points = listed_points(set, T);
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
  std::size_t points_ = 0;
};

}  // namespace opal::ifc_importer::ifcpp
