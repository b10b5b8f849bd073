#pragma once

// Part of ifc_model.cpp: faces of an IfcAdvancedBrep as flat facets. The library does not read them.

#include "curves.hpp"

#include <ifcpp/IFC4/include/IfcCylindricalSurface.h>
#include <ifcpp/IFC4/include/IfcEdgeCurve.h>
#include <ifcpp/IFC4/include/IfcEdgeLoop.h>
#include <ifcpp/IFC4/include/IfcFaceBound.h>
#include <ifcpp/IFC4/include/IfcFaceSurface.h>
#include <ifcpp/IFC4/include/IfcOrientedEdge.h>
#include <ifcpp/IFC4/include/IfcPlane.h>
#include <ifcpp/IFC4/include/IfcPolyLoop.h>
#include <ifcpp/IFC4/include/IfcVertexPoint.h>

namespace opal::ifc_importer::ifcpp {

class AdvancedFaces {
 public:
  AdvancedFaces(const Curves& curves, double unit_m) : curves_(curves), unit_m_(unit_m) {}

  /// In the solid's own frame [m]. @throws Unreadable for surfaces other than planes and cylinders.
  Shell facets(const IfcFace& face) const {
    FaceLoops loops;
    for (const auto& bound : face.m_Bounds) loops.push_back(loop_of(bound));
    const auto* on_surface = dynamic_cast<const IfcFaceSurface*>(&face);
    if (!on_surface || as<IfcPlane>(on_surface->m_FaceSurface)) return {loops};
    const auto cylinder = as<IfcCylindricalSurface>(on_surface->m_FaceSurface);
    if (!cylinder)
      throw Unreadable(
          "IfcAdvancedBrep: a face on an " +
          std::string(on_surface->m_FaceSurface ? on_surface->m_FaceSurface->className() : "unknown surface") +
          ", which is not cut");
    const double radius_m = unit_m_ * number_of(cylinder->m_Radius, "radius");
    if (!(radius_m > 0)) throw Unreadable("a cylinder without radius");
    return strips(loops, transform_of(cylinder->m_Position, unit_m_), radius_m);
  }

 private:
  /// Heading around the axis [rad], and distance along it [m].
  using Unrolled = std::vector<Point>;

  std::vector<Point3> loop_of(const shared_ptr<IfcFaceBound>& bound) const {
    std::vector<Point3> points;
    const auto edges = bound ? as<IfcEdgeLoop>(bound->m_Bound) : nullptr;
    const auto corners = bound ? as<IfcPolyLoop>(bound->m_Bound) : nullptr;
    if (!edges && !corners) throw Unreadable("IfcAdvancedBrep: a face without edges");
    if (corners)
      for (const auto& corner : corners->m_Polygon) points.push_back(point_of(corner, unit_m_));
    if (edges)
      for (const auto& edge : edges->m_EdgeList) {
        const std::vector<Point3> way = points_of(edge);
        points.insert(points.end(), way.begin(), way.end() - 1);
      }
    if (points.size() < 2) throw Unreadable("IfcAdvancedBrep: a face without edges");
    return points;
  }

  Point3 corner_of(const shared_ptr<IfcVertex>& vertex) const {
    const auto point = as<IfcVertexPoint>(vertex);
    return point_of(point ? as<IfcCartesianPoint>(point->m_VertexGeometry) : nullptr, unit_m_);
  }

  std::vector<Point3> points_of(const shared_ptr<IfcOrientedEdge>& oriented) const {
    if (!oriented || !oriented->m_EdgeElement) throw Unreadable("IfcAdvancedBrep: an edge is missing");
    const Point3 begin = corner_of(oriented->m_EdgeElement->m_EdgeStart),
                 end = corner_of(oriented->m_EdgeElement->m_EdgeEnd);
    std::vector<Point3> points{begin, end};
    if (const auto curved = as<IfcEdgeCurve>(oriented->m_EdgeElement))
      points =
          curves_.between(curved->m_EdgeGeometry, begin, end, !curved->m_SameSense || curved->m_SameSense->m_value);
    if (oriented->m_Orientation && !oriented->m_Orientation->m_value) std::reverse(points.begin(), points.end());
    return points;
  }

  static Shell strips(const FaceLoops& loops, const Transform3& T, double radius_m) {
    std::vector<Unrolled> closed, around;
    for (const auto& loop : loops) {
      Unrolled unrolled = unroll(loop, T);
      (std::abs(unrolled.back().x() - unrolled.front().x()) > std::numbers::pi ? around : closed)
          .push_back(std::move(unrolled));
    }
    if (!around.empty()) closed.push_back(tube(std::move(around)));
    double from = 1e9, to = -1e9;
    for (const Unrolled& loop : closed)
      for (const Point& p : loop) from = std::min(from, p.x()), to = std::max(to, p.x());
    const double width = 2 * std::numbers::pi / kStrips;
    Shell shell;
    for (double k = std::floor(from / width); k * width < to; ++k) {
      FaceLoops facet;
      for (const Unrolled& loop : closed)
        if (const Unrolled part = clipped(clipped(loop, k * width, 1), (k + 1) * width, -1); part.size() >= 3)
          facet.push_back(rolled(part, T, radius_m));
      if (!facet.empty()) shell.push_back(std::move(facet));
    }
    return shell;
  }

  /// The first point comes again at the end: a whole turn on, if the loop goes around the axis.
  static Unrolled unroll(const std::vector<Point3>& loop, const Transform3& T) {
    Unrolled unrolled;
    for (std::size_t k = 0; k <= loop.size(); ++k) {
      const Point3 own = T.inverse() * loop[k % loop.size()];
      double heading = std::atan2(own.y(), own.x());
      if (!unrolled.empty()) heading = unrolled.back().x() + wrap_angle(heading - unrolled.back().x());
      unrolled.emplace_back(heading, own.z());
    }
    return unrolled;
  }

  /// Between two loops around the axis.
  static Unrolled tube(std::vector<Unrolled> around) {
    if (around.size() != 2) throw Unreadable("IfcAdvancedBrep: a face around a cylinder that has no two ends");
    const auto turns_left = [](const Unrolled& loop) { return loop.back().x() > loop.front().x(); };
    if (turns_left(around[0]) == turns_left(around[1])) std::reverse(around[1].begin(), around[1].end());
    const double apart = around[0].back().x() - around[1].front().x();
    const double shift = 2 * std::numbers::pi * std::round(apart / (2 * std::numbers::pi));
    for (const Point& p : around[1]) around[0].emplace_back(p.x() + shift, p.y());
    return std::move(around[0]);
  }

  /// What lies on one side of a heading (Sutherland and Hodgman 1974).
  static Unrolled clipped(const Unrolled& loop, double heading, double side) {
    Unrolled kept;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point &a = loop[k], &b = loop[(k + 1) % loop.size()];
      const double from = side * (a.x() - heading), to = side * (b.x() - heading);
      if (from >= 0) kept.push_back(a);
      if ((from < 0) != (to < 0)) kept.emplace_back(heading, a.y() + from / (from - to) * (b.y() - a.y()));
    }
    return kept;
  }

  static std::vector<Point3> rolled(const Unrolled& loop, const Transform3& T, double radius_m) {
    std::vector<Point3> points;
    for (const Point& p : loop)
      points.push_back(T * Point3(radius_m * std::cos(p.x()), radius_m * std::sin(p.x()), p.y()));
    return points;
  }

  static constexpr int kStrips = 72;  // around a cylinder

  const Curves& curves_;
  double unit_m_;
};

}  // namespace opal::ifc_importer::ifcpp
