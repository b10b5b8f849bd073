#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

using opal::GeometryKind;
using Options = nlohmann::json;
using Made = std::unique_ptr<opal::PatternTemplate>;

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:ColumnPair", /*consumes*/ {"opal:Column"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<PointPair>(std::array{GeometryKind::circle, GeometryKind::circle}, options);
  });
  registrar.add({"opal:CornerPair", /*consumes*/ {"opal:Corner"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<PointPair>(std::array{GeometryKind::oriented_point, GeometryKind::oriented_point}, options);
  });
  registrar.add(
      {"opal:ColumnCornerPair", /*consumes*/ {"opal:Column", "opal:Corner"}, /*produces*/ {}},
      [](const Options& options) -> Made {
        return std::make_unique<PointPair>(std::array{GeometryKind::circle, GeometryKind::oriented_point}, options);
      });
  registrar.add(
      {"opal:ColumnWallPair", /*consumes*/ {"opal:Column", "opal:Wall"}, /*produces*/ {}},
      [](const Options& options) -> Made { return std::make_unique<PairWithWall>(GeometryKind::circle, options); });
  registrar.add({"opal:CornerWallPair", /*consumes*/ {"opal:Corner", "opal:Wall"}, /*produces*/ {}},
                [](const Options& options) -> Made {
                  return std::make_unique<PairWithWall>(GeometryKind::oriented_point, options);
                });
}

}  // namespace

OPAL_PLUGIN("column_pair", "0.1.0", register_types)
