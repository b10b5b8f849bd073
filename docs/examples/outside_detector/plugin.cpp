#include "detector.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<PostDetector>({.name = "acme:PostDetector", .produces = {"acme:Post"}});
}

}  // namespace

OPAL_PLUGIN("posts", "1.0.0", register_types)
