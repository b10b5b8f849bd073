#include <opal/patterns/pattern_template.hpp>

namespace opal {

PatternTemplate::~PatternTemplate() = default;

}  // namespace opal
