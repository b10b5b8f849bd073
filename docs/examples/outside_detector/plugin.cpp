#include "detector.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"acme:PostDetector", /*consumes*/ {}, /*produces*/ {"acme:Post"}},
                [](const nlohmann::json& options) { return std::make_unique<PostDetector>(options); });
}

}  // namespace

OPAL_PLUGIN("posts", "1.0.0", register_types)
