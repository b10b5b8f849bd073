#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::line_pair::LinePair>({.name = "opal:LinePair", .consumes = {"opal:Wall"}});
}

}  // namespace

OPAL_PLUGIN("line_pair", "0.1.0", register_types)
