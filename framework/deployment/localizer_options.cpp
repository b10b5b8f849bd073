#include "deployment/localizer_options.hpp"

#include "common/phrases.hpp"
#include "deployment/stage_fields.hpp"
#include "plugin/plugin_options.hpp"

#include <opal/common/error.hpp>

#include <algorithm>

namespace opal {
namespace {

/// Calls `use(name, description, stage)` for every stage, in pipeline order.
template <class Options, class Use>
void for_each_stage(Options& options, Use&& use) {
  use("tempering", "how much each scan counts as independent evidence", options.tempering);
  use("schedule", "how often the map is searched", options.schedule);
  use("search", "which patterns are looked up on the map, and how many candidates pass each filter", options.search);
  use("verification", "how candidates are judged by earlier scans", options.verification);
  use("growth", "how local features are paired with mapped ones in the association tree", options.growth);
  use("tracking", "how hypotheses carry pose and evidence from scan to scan", options.tracking);
  use("hypotheses", "how hypotheses begin and end", options.hypotheses);
  use("status", "when the robot is called localized, and when lost", options.status);
  use("kidnapping", "when the robot is suspected to have been put elsewhere", options.kidnapping);
  use("rides", "when a lift may have taken the robot to another storey", options.rides);
}

template <class Stage>
OptionInfo described(const StageField<Stage>& field, const Stage& stage) {
  OptionInfo info{field.name, "boolean", field.unit, nullptr, nullptr, nullptr, field.meaning};
  if (const auto* flag = std::get_if<bool Stage::*>(&field.member)) {
    info.default_value = stage.**flag;
    return info;
  }
  if (const auto* whole = std::get_if<int Stage::*>(&field.member)) {
    info.type = "integer";
    info.default_value = stage.**whole;
    info.minimum = static_cast<int>(field.minimum);
    info.maximum = static_cast<int>(field.maximum);
    return info;
  }
  info.type = "number";
  info.default_value = stage.*std::get<double Stage::*>(field.member);
  info.minimum = field.minimum;
  info.maximum = field.maximum;
  return info;
}

template <class Stage>
void set(Stage& stage, const StageField<Stage>& field, const nlohmann::json& value, const std::string& where) {
  const OptionInfo info = described(field, Stage());
  if (!is_acceptable(info, value))
    throw ConfigError(where + ": " + value.dump() + ", expected " + accepted_values(info));
  std::visit([&](auto member) { value.get_to(stage.*member); }, field.member);
}

constexpr const char* kRegion = "region";

RegionPrior read_region(const nlohmann::json& value, const std::string& where) {
  const auto number = [&](const char* key, double minimum) {
    const OptionInfo info{key, "number", "m", nullptr, minimum, 1e6, ""};
    if (!is_acceptable(info, value[key]))
      throw ConfigError(where + "/" + key + ": " + value[key].dump() + ", expected " + accepted_values(info));
    return value[key].get<double>();
  };
  if (!value.is_object() || value.size() != 3 || !value.contains("x_m") || !value.contains("y_m") ||
      !value.contains("radius_m"))
    throw ConfigError(where + ": " + value.dump() + ", expected an object with x_m, y_m and radius_m");
  return {{number("x_m", -1e6), number("y_m", -1e6)}, number("radius_m", 1e-3)};
}

/// What is no plain number of a stage.
template <class Stage>
bool read_other(Stage&, const std::string&, const nlohmann::json&, const std::string&) {
  return false;
}
bool read_other(SearchOptions& stage, const std::string& name, const nlohmann::json& value, const std::string& where) {
  if (name != kRegion) return false;
  stage.region = read_region(value, where);
  return true;
}

template <class Stage>
void read_stage(Stage& stage, const nlohmann::json& given, const std::string& where) {
  if (!given.is_object()) throw ConfigError(where + ": " + given.dump() + ", expected an object of options");
  for (const auto& [name, value] : given.items()) {
    const std::string here = where + "/" + name;
    if (read_other(stage, name, value, here)) continue;
    const auto& fields = fields_of(stage);
    const auto field = std::ranges::find_if(fields, [&, &key = name](const auto& f) { return key == f.name; });
    if (field != fields.end()) {
      set(stage, *field, value, here);
      continue;
    }
    throw ConfigError(here +
                      ": unknown option, expected one of: " + listed_by(fields, [](const auto& f) { return f.name; }));
  }
}

}  // namespace

std::vector<DescribedStage> describe_stages() {
  std::vector<DescribedStage> stages;
  const LocalizerOptions defaults;
  for_each_stage(defaults, [&](const char* name, const char* description, const auto& stage) {
    stages.push_back({name, description, {}});
    for (const auto& field : fields_of(stage)) stages.back().options.push_back(described(field, stage));
    if (stages.back().name == "search")
      stages.back().options.push_back(
          {kRegion, "object", "", nullptr, nullptr, nullptr,
           "Where the robot is known to be: an object of three numbers, x_m and y_m of the centre "
           "[m, frame map] and radius_m [m]. null: anywhere."});
  });
  return stages;
}

LocalizerOptions read_localizer_options(const nlohmann::json& stages, const std::string& where,
                                        LocalizerOptions options) {
  if (!stages.is_object()) throw ConfigError(where + ": " + stages.dump() + ", expected an object of stages");
  std::vector<std::string> known;
  std::size_t read = 0;
  for_each_stage(options, [&](const char* name, const char*, auto& stage) {
    known.emplace_back(name);
    if (!stages.contains(name)) return;
    read_stage(stage, stages[name], where + "/" + name);
    ++read;
  });
  if (read == stages.size()) return options;
  for (const auto& [name, value] : stages.items())
    if (std::ranges::find(known, name) == known.end())
      throw ConfigError(where + "/" + name + ": unknown stage, expected one of: " + listed(known));
  return options;
}

}  // namespace opal
