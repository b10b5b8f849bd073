#pragma once

// Part of ifc_model.cpp: points along curves. The library drops the segments of indexed curves, and takes splines for
// something near to their control points.

#include "../step_arguments.hpp"
#include "placements.hpp"

#include <opal/import_kit/b_spline.hpp>
#include <opal/import_kit/plan_assembly.hpp>

#include <ifcpp/IFC4/include/IfcBSplineCurveWithKnots.h>
#include <ifcpp/IFC4/include/IfcCartesianPointList2D.h>
#include <ifcpp/IFC4/include/IfcCartesianPointList3D.h>
#include <ifcpp/IFC4/include/IfcCircle.h>
#include <ifcpp/IFC4/include/IfcCompositeCurve.h>
#include <ifcpp/IFC4/include/IfcCompositeCurveSegment.h>
#include <ifcpp/IFC4/include/IfcEllipse.h>
#include <ifcpp/IFC4/include/IfcIndexedPolyCurve.h>
#include <ifcpp/IFC4/include/IfcInteger.h>
#include <ifcpp/IFC4/include/IfcLine.h>
#include <ifcpp/IFC4/include/IfcParameterValue.h>
#include <ifcpp/IFC4/include/IfcPositiveInteger.h>
#include <ifcpp/IFC4/include/IfcRationalBSplineCurveWithKnots.h>
#include <ifcpp/IFC4/include/IfcTrimmedCurve.h>
#include <ifcpp/IFC4/include/IfcTrimmingPreference.h>
#include <ifcpp/IFC4/include/IfcTrimmingSelect.h>
#include <ifcpp/IFC4/include/IfcVector.h>

#include <numbers>
#include <unordered_map>

namespace opal::ifc_importer::ifcpp {

// Chords are nearer than this to what they stand for, and of a circle there are at least 72.
constexpr double kChord_m = 0.002;
constexpr double kChordShare = 9.5e-4;  // of the radius
constexpr double kSameJoint_m = 1e-3;
constexpr int kCurvesInCurves = 20;

/// By the number of the curve.
using IndexedCurves = std::unordered_map<int, std::vector<IndexedSegment>>;

class Curves {
 public:
  /// @param unit_m, angle_rad  lengths of the model's units.
  Curves(double unit_m, double angle_rad, IndexedCurves indexed)
      : unit_m_(unit_m), angle_rad_(angle_rad), indexed_(std::move(indexed)) {}

  /// In the curve's own frame [m], both ends included. @throws Unreadable for kinds that are not computed.
  std::vector<Point3> points(const shared_ptr<IfcCurve>& curve, int depth = 0) const {
    if (depth > kCurvesInCurves) throw Unreadable("curves within curves without an end");
    if (const auto line = as<IfcPolyline>(curve)) return of_polyline(*line);
    if (const auto line = as<IfcIndexedPolyCurve>(curve)) return of_indexed(*line);
    if (const auto parts = as<IfcCompositeCurve>(curve)) return of_composite(*parts, depth);
    if (const auto trimmed = as<IfcTrimmedCurve>(curve)) return of_trimmed(*trimmed);
    if (const auto conic = as<IfcConic>(curve)) return of_conic(ellipse_of(*conic), 0, 2 * std::numbers::pi);
    if (const auto spline = as<IfcBSplineCurve>(curve)) return of_spline(*spline);
    throw Unreadable(curve ? std::string(curve->className()) + ": curves of this kind are not computed"
                           : "a curve is missing");
  }

  /// Along a curve from one of its points to another, both included; around a closed one if they are the same.
  std::vector<Point3> between(const shared_ptr<IfcCurve>& curve, const Point3& begin, const Point3& end,
                              bool forward) const {
    if (as<IfcLine>(curve)) return {begin, end};
    std::vector<Point3> points;
    if (const auto conic = as<IfcConic>(curve)) {
      const Ellipse ellipse = ellipse_of(*conic);
      const double from_rad = angle_on(ellipse, begin);
      points = of_conic(ellipse, from_rad, sweep_rad(from_rad, angle_on(ellipse, end), forward));
    } else {
      points = this->points(curve);
      if (points.size() > 1 && !is_same(points.front(), begin)) std::ranges::reverse(points);
    }
    if (points.size() < 2 || !is_same(points.front(), begin) || !is_same(points.back(), end))
      throw Unreadable("an edge that is not the whole of its curve, or beside it");
    points.front() = begin;
    points.back() = end;
    return points;
  }

 private:
  struct Ellipse {
    Transform3 T = Transform3::Identity();
    double a = 0, b = 0;
  };

  std::vector<Point3> of_polyline(const IfcPolyline& line) const {
    std::vector<Point3> points;
    for (const auto& point : line.m_Points) points.push_back(point_of(point, unit_m_));
    return points;
  }

  std::vector<Point3> of_indexed(const IfcIndexedPolyCurve& curve) const {
    const std::vector<Point3> all = listed(curve.m_Points);
    const auto segments = indexed_.find(curve.m_entity_id);
    if (segments == indexed_.end()) return all;
    std::vector<Point3> points;
    for (const IndexedSegment& segment : segments->second) {
      const std::vector<Point3> corners = picked(all, segment.points);
      if (corners.size() < 2 || (segment.is_arc && corners.size() != 3))
        throw Unreadable("an indexed curve with a segment that is neither line nor arc");
      append(segment.is_arc ? arc_through(corners[0], corners[1], corners[2]) : corners, points);
    }
    return points;
  }

  std::vector<Point3> listed(const shared_ptr<IfcCartesianPointList>& list) const {
    std::vector<Point3> points;
    const auto take = [&](const auto& rows) {
      for (const auto& row : rows) points.push_back(unit_m_ * coordinates(row, "a point"));
    };
    if (const auto flat = as<IfcCartesianPointList2D>(list)) take(flat->m_CoordList);
    if (const auto in_space = as<IfcCartesianPointList3D>(list)) take(in_space->m_CoordList);
    if (points.empty()) throw Unreadable("an indexed curve without points");
    return points;
  }

  static std::vector<Point3> picked(const std::vector<Point3>& all, const std::vector<int>& numbers) {
    std::vector<Point3> points;
    for (const int number : numbers) {
      if (number < 1 || static_cast<std::size_t>(number) > all.size())
        throw Unreadable("an indexed curve that names a point which it does not have");
      points.push_back(all[static_cast<std::size_t>(number) - 1]);
    }
    return points;
  }

  /// Straight, if the three lie on a line.
  static std::vector<Point3> arc_through(const Point3& from, const Point3& by, const Point3& to) {
    const Point3 a = by - from, b = to - from, n = a.cross(b);
    if (n.norm() < 1e-9 * a.norm() * b.norm() || a.norm() == 0 || b.norm() == 0) return {from, by, to};
    const Point3 center = from + (b.squaredNorm() * n.cross(a) + a.squaredNorm() * b.cross(n)) / (2 * n.squaredNorm());
    const Ellipse circle{frame(center, n.normalized(), from - center), (from - center).norm(), (from - center).norm()};
    double sweep_rad = angle_on(circle, to);
    if (sweep_rad <= 0) sweep_rad += 2 * std::numbers::pi;
    return of_conic(circle, 0, sweep_rad);
  }

  /// Parts that were written the wrong way round are turned.
  std::vector<Point3> of_composite(const IfcCompositeCurve& curve, int depth) const {
    std::vector<Point3> points;
    int parts = 0;
    for (const auto& segment : curve.m_Segments) {
      if (!segment) throw Unreadable("a composite curve that lacks a segment");
      std::vector<Point3> part = this->points(segment->m_ParentCurve, depth + 1);
      if (part.empty()) continue;
      if (segment->m_SameSense && !segment->m_SameSense->m_value) std::ranges::reverse(part);
      if (parts++ == 1 && !has_end(part, points.back()) && has_end(part, points.front())) std::ranges::reverse(points);
      if (parts > 1 && !is_same(part.front(), points.back()) && is_same(part.back(), points.back()))
        std::ranges::reverse(part);
      append(part, points);
    }
    return points;
  }

  static bool is_same(const Point3& a, const Point3& b) { return (a - b).norm() < kSameJoint_m; }
  static bool has_end(const std::vector<Point3>& part, const Point3& p) {
    return is_same(part.front(), p) || is_same(part.back(), p);
  }

  std::vector<Point3> of_trimmed(const IfcTrimmedCurve& curve) const {
    const bool forward = !curve.m_SenseAgreement || curve.m_SenseAgreement->m_value;
    const bool by_points =
        curve.m_MasterRepresentation && curve.m_MasterRepresentation->m_enum == IfcTrimmingPreference::ENUM_CARTESIAN;
    if (const auto line = as<IfcLine>(curve.m_BasisCurve))
      return {on_line(*line, curve.m_Trim1, by_points), on_line(*line, curve.m_Trim2, by_points)};
    const auto conic = as<IfcConic>(curve.m_BasisCurve);
    if (!conic) throw Unreadable("a trimmed curve whose basis is no line, circle or ellipse");
    const Ellipse ellipse = ellipse_of(*conic);
    const double from_rad = on_conic(ellipse, curve.m_Trim1, by_points),
                 to_rad = on_conic(ellipse, curve.m_Trim2, by_points);
    return of_conic(ellipse, from_rad, sweep_rad(from_rad, to_rad, forward));
  }

  /// A whole turn between equal angles.
  static double sweep_rad(double from_rad, double to_rad, bool forward) {
    const double sweep_rad = std::remainder(to_rad - from_rad, 2 * std::numbers::pi);
    if (forward) return sweep_rad <= 1e-9 ? sweep_rad + 2 * std::numbers::pi : sweep_rad;
    return sweep_rad >= -1e-9 ? sweep_rad - 2 * std::numbers::pi : sweep_rad;
  }

  using Trim = std::vector<shared_ptr<IfcTrimmingSelect>>;

  template <class T>
  static shared_ptr<T> first(const Trim& trim) {
    for (const auto& select : trim)
      if (const auto found = as<T>(select)) return found;
    return nullptr;
  }

  Point3 on_line(const IfcLine& line, const Trim& trim, bool by_points) const {
    const auto parameter = first<IfcParameterValue>(trim);
    const auto point = first<IfcCartesianPoint>(trim);
    if (point && (by_points || !parameter)) return point_of(point, unit_m_);
    if (!line.m_Dir) throw Unreadable("a line without direction");
    return point_of(line.m_Pnt, unit_m_) + number_of(parameter, "trimming value") * unit_m_ *
                                               number_of(line.m_Dir->m_Magnitude, "magnitude") *
                                               direction_of(line.m_Dir->m_Orientation, Point3::UnitX());
  }

  double on_conic(const Ellipse& ellipse, const Trim& trim, bool by_points) const {
    const auto parameter = first<IfcParameterValue>(trim);
    const auto point = first<IfcCartesianPoint>(trim);
    if (point && (by_points || !parameter)) return angle_on(ellipse, point_of(point, unit_m_));
    return angle_rad_ * number_of(parameter, "trimming value");
  }

  static double angle_on(const Ellipse& ellipse, const Point3& point) {
    const Point3 own = ellipse.T.inverse() * point;
    return std::atan2(own.y() / ellipse.b, own.x() / ellipse.a);
  }

  Ellipse ellipse_of(const IfcConic& conic) const {
    Ellipse ellipse{transform_of(conic.m_Position, unit_m_)};
    if (const auto* circle = dynamic_cast<const IfcCircle*>(&conic))
      ellipse.a = ellipse.b = unit_m_ * number_of(circle->m_Radius, "radius");
    if (const auto* oval = dynamic_cast<const IfcEllipse*>(&conic)) {
      ellipse.a = unit_m_ * number_of(oval->m_SemiAxis1, "semi-axis");
      ellipse.b = unit_m_ * number_of(oval->m_SemiAxis2, "semi-axis");
    }
    if (!(ellipse.a > 0 && ellipse.b > 0 && std::max(ellipse.a, ellipse.b) < 1e7))
      throw Unreadable("a circle or ellipse without a size");
    return ellipse;
  }

  static std::vector<Point3> of_conic(const Ellipse& ellipse, double from_rad, double sweep_rad) {
    const double largest_m = std::max(ellipse.a, ellipse.b);
    const double tolerance = std::min(kChord_m / largest_m, kChordShare);
    std::vector<Point3> points;
    for (const Point& p : arc_points({Point::Zero(), 1}, from_rad, sweep_rad, tolerance))
      points.push_back(ellipse.T * Point3(ellipse.a * p.x(), ellipse.b * p.y(), 0));
    return points;
  }

  std::vector<Point3> of_spline(const IfcBSplineCurve& curve) const {
    BSpline spline;
    spline.degree = curve.m_Degree ? curve.m_Degree->m_value : 0;
    for (const auto& point : curve.m_ControlPointsList) spline.control_points.push_back(point_of(point, unit_m_));
    const auto* with_knots = dynamic_cast<const IfcBSplineCurveWithKnots*>(&curve);
    if (!with_knots || with_knots->m_Knots.size() != with_knots->m_KnotMultiplicities.size())
      throw Unreadable("a spline without knots");
    for (std::size_t k = 0; k < with_knots->m_Knots.size(); ++k) {
      const auto& times = with_knots->m_KnotMultiplicities[k];
      if (!times || times->m_value < 1 || times->m_value > 100)
        throw Unreadable("a spline with a knot that is not there");
      spline.knots.insert(spline.knots.end(), static_cast<std::size_t>(times->m_value),
                          number_of(with_knots->m_Knots[k], "knot"));
    }
    if (const auto* rational = dynamic_cast<const IfcRationalBSplineCurveWithKnots*>(&curve))
      for (const auto& weight : rational->m_WeightsData) spline.weights.push_back(number_of(weight, "weight"));
    if (const std::string fault = fault_of(spline); !fault.empty()) throw Unreadable(fault);
    return chord_points(spline, kChord_m);
  }

  /// A joint is there once.
  static void append(const std::vector<Point3>& part, std::vector<Point3>& points) {
    for (const Point3& p : part)
      if (points.empty() || (p - points.back()).norm() > 1e-9) points.push_back(p);
  }

  double unit_m_, angle_rad_;
  IndexedCurves indexed_;
};

}  // namespace opal::ifc_importer::ifcpp
