#include <opal/plugin/registrar.hpp>

namespace opal {

Registrar::~Registrar() = default;

}  // namespace opal
