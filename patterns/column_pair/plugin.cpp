#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

using opal::GeometryKind;

void register_types(opal::Registrar& registrar) {
  constexpr GeometryKind column = GeometryKind::circle, corner = GeometryKind::oriented_point;
  registrar.add<opal::column_pair::PointPair>({.name = "opal:ColumnPair", .consumes = {"opal:Column"}},
                                              std::array{column, column});
  registrar.add<opal::column_pair::PointPair>({.name = "opal:CornerPair", .consumes = {"opal:Corner"}},
                                              std::array{corner, corner});
  registrar.add<opal::column_pair::PointPair>(
      {.name = "opal:ColumnCornerPair", .consumes = {"opal:Column", "opal:Corner"}}, std::array{column, corner});
  registrar.add<opal::column_pair::PairWithWall>(
      {.name = "opal:ColumnWallPair", .consumes = {"opal:Column", "opal:Wall"}}, column);
  registrar.add<opal::column_pair::PairWithWall>(
      {.name = "opal:CornerWallPair", .consumes = {"opal:Corner", "opal:Wall"}}, corner);
}

}  // namespace

OPAL_PLUGIN("column_pair", "0.1.0", register_types)
