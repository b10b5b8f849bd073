#pragma once

#include <opal/plugin/plugin_description.hpp>

namespace opal {

bool is_acceptable(const OptionInfo& option, const nlohmann::json& value);

}  // namespace opal
