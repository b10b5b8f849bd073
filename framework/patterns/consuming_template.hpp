#pragma once

#include <opal/patterns/pattern_template.hpp>

#include <memory>
#include <string>
#include <vector>

namespace opal {

/// The template for features of some types only: a tuple with a feature of another type is no instance, whatever its
/// geometry.
/// @param consumes  feature types; empty: any.
OPAL_EXPORT std::shared_ptr<const PatternTemplate> consuming(std::shared_ptr<const PatternTemplate> pattern_template,
                                                             std::vector<std::string> consumes);

}  // namespace opal
