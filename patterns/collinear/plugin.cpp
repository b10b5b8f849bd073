#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

using opal::GeometryKind;

void register_types(opal::Registrar& registrar) {
  constexpr GeometryKind column = GeometryKind::circle, corner = GeometryKind::oriented_point;
  registrar.add<opal::collinear::Collinear>({.name = "opal:Collinear", .consumes = {"opal:Column"}}, column, column);
  registrar.add<opal::collinear::Collinear>({.name = "opal:CollinearCorners", .consumes = {"opal:Corner"}}, corner,
                                            corner);
  registrar.add<opal::collinear::Collinear>({.name = "opal:CollinearMixed", .consumes = {"opal:Corner", "opal:Column"}},
                                            corner, column);
}

}  // namespace

OPAL_PLUGIN("collinear", "0.1.0", register_types)
