#pragma once

#include <opal/localization/options/localizer_options.hpp>
#include <opal/plugin/plugin_description.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal {

/// One stage of the localizer as a deployment's "stages" names it.
struct DescribedStage {
  std::string name;
  std::string description;
  std::vector<OptionInfo> options;
};

/// All stages in pipeline order, with meaning, unit, default and range of every option.
OPAL_EXPORT std::vector<DescribedStage> describe_stages();

/// Reads the object "stages" of a deployment strictly.
/// @param where  file and JSON pointer of the object, for messages.
/// @param options  what holds where the object says nothing.
/// @throws ConfigError "FILE: /stages/search/patterns: 0, expected an integer from 1 to 1000".
OPAL_EXPORT LocalizerOptions read_localizer_options(const nlohmann::json& stages, const std::string& where,
                                                    LocalizerOptions options = {});

}  // namespace opal
