#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

using opal::GeometryKind;
using Options = nlohmann::json;
using Made = std::unique_ptr<opal::PatternTemplate>;

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:Binary", /*consumes*/ {"opal:Column"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<Binary>(std::array{GeometryKind::circle, GeometryKind::circle}, options);
  });
  registrar.add({"opal:BinaryCorners", /*consumes*/ {"opal:Corner"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<Binary>(std::array{GeometryKind::oriented_point, GeometryKind::oriented_point}, options);
  });
  registrar.add({"opal:BinaryColumnCorner", /*consumes*/ {"opal:Column", "opal:Corner"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<Binary>(std::array{GeometryKind::circle, GeometryKind::oriented_point}, options);
  });
  registrar.add({"opal:BinaryColumnWall", /*consumes*/ {"opal:Column", "opal:Wall"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<BinaryWithWall>(GeometryKind::circle, options);
  });
  registrar.add({"opal:BinaryCornerWall", /*consumes*/ {"opal:Corner", "opal:Wall"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<BinaryWithWall>(GeometryKind::oriented_point, options);
  });
}

}  // namespace

OPAL_PLUGIN("binary", "0.1.0", register_types)
