#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

using opal::GeometryKind;
using Options = nlohmann::json;
using Made = std::unique_ptr<opal::PatternTemplate>;

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:Collinear", /*consumes*/ {"opal:Column"}, /*produces*/ {}}, [](const Options& options) -> Made {
    return std::make_unique<Collinear>(GeometryKind::circle, GeometryKind::circle, options);
  });
  registrar.add(
      {"opal:CollinearCorners", /*consumes*/ {"opal:Corner"}, /*produces*/ {}}, [](const Options& options) -> Made {
        return std::make_unique<Collinear>(GeometryKind::oriented_point, GeometryKind::oriented_point, options);
      });
  registrar.add({"opal:CollinearMixed", /*consumes*/ {"opal:Corner", "opal:Column"}, /*produces*/ {}},
                [](const Options& options) -> Made {
                  return std::make_unique<Collinear>(GeometryKind::oriented_point, GeometryKind::circle, options);
                });
}

}  // namespace

OPAL_PLUGIN("collinear", "0.1.0", register_types)
