#pragma once

#include <opal/common/feature.hpp>

#include <cmath>
#include <variant>

namespace opal {

/// All of its numbers are neither infinite nor NaN.
inline bool is_finite(const Geometry& geometry) {
  struct IsFinite {
    bool operator()(const Point& p) const { return p.allFinite(); }
    bool operator()(const OrientedPoint& p) const {
      return p.position.allFinite() && std::isfinite(p.heading_rad) && std::isfinite(p.opening_rad);
    }
    bool operator()(const Segment& s) const { return s.begin.allFinite() && s.end.allFinite(); }
    bool operator()(const Circle& c) const { return c.center.allFinite() && std::isfinite(c.radius_m); }
  };
  return std::visit(IsFinite{}, geometry);
}

}  // namespace opal
