#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

using opal::GeometryKind;

void register_types(opal::Registrar& registrar) {
  constexpr GeometryKind column = GeometryKind::circle, corner = GeometryKind::oriented_point;
  registrar.add<Collinear>({.name = "opal:Collinear", .consumes = {"opal:Column"}}, column, column);
  registrar.add<Collinear>({.name = "opal:CollinearCorners", .consumes = {"opal:Corner"}}, corner, corner);
  registrar.add<Collinear>({.name = "opal:CollinearMixed", .consumes = {"opal:Corner", "opal:Column"}}, corner, column);
}

}  // namespace

OPAL_PLUGIN("collinear", "0.1.0", register_types)
