#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

using opal::GeometryKind;

void register_types(opal::Registrar& registrar) {
  constexpr GeometryKind column = GeometryKind::circle, corner = GeometryKind::oriented_point;
  registrar.add<opal::l_shape::LShape>({.name = "opal:LShape", .consumes = {"opal:Column"}}, column, column);
  registrar.add<opal::l_shape::LShape>({.name = "opal:LShapeCorners", .consumes = {"opal:Corner"}}, corner, corner);
  registrar.add<opal::l_shape::LShape>({.name = "opal:LShapeMixed", .consumes = {"opal:Corner", "opal:Column"}}, corner,
                                       column);
}

}  // namespace

OPAL_PLUGIN("l_shape", "0.1.0", register_types)
