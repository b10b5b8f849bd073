#include "deployment/localizer_options.hpp"

#include "common/phrases.hpp"
#include "plugin/plugin_options.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <variant>

namespace opal {
namespace {

constexpr double kMany = 1e6;

/// One option of a stage: where it is kept, and what is told of it. Defaults are those of the struct.
template <class Stage>
struct Field {
  const char* name;
  std::variant<int Stage::*, double Stage::*, bool Stage::*> member;
  const char* unit;
  double minimum, maximum;
  const char* meaning;
};

template <class Stage>
using Fields = std::vector<Field<Stage>>;

const Fields<TemperingOptions>& fields_of(const TemperingOptions&) {
  using O = TemperingOptions;
  static const Fields<O> all = {
      {"distance_m", &O::distance_m, "m", 0.001, 1000,
       "driving that makes a scan a whole, independent piece of evidence"},
      {"angle_rad", &O::angle_rad, "rad", 0.001, 1000,
       "turning that makes a scan a whole, independent piece of evidence"},
      {"least_weight", &O::least_weight, "", 0, 1, "weight of a scan that was taken where the one before was"},
  };
  return all;
}

const Fields<SearchScheduleOptions>& fields_of(const SearchScheduleOptions&) {
  using O = SearchScheduleOptions;
  static const Fields<O> all = {
      {"every_m", &O::every_m, "m", 0, 1000, "driving that brings a chance to search"},
      {"every_rad", &O::every_rad, "rad", 0, 1000, "turning that brings a chance to search"},
      {"every_when_localized", &O::every_when_localized, "", 1, kMany, "chances that make one search while localized"},
      {"every_when_likely", &O::every_when_likely, "", 1, kMany,
       "chances that make one search while the best place is likely"},
      {"likely_probability", &O::likely_probability, "", 0, 1, "probability above which the best place is likely"},
  };
  return all;
}

const Fields<SearchOptions>& fields_of(const SearchOptions&) {
  using O = SearchOptions;
  static const Fields<O> all = {
      {"patterns", &O::patterns, "", 1, 1000, "patterns looked up per scan, fewest expected candidates first"},
      {"lookup_limit", &O::lookup_limit, "", 1, kMany, "candidates per search and template"},
      {"places", &O::places, "", 0, kMany, "candidates per search of all templates together; 0: any number"},
      {"places_per_scan", &O::places_per_scan, "", 0, kMany,
       "places looked at per scan: a search that has more goes on at the next ones; 0: any number"},
      {"close_looks", &O::close_looks, "", 1, kMany, "places that are judged by all points of a thinned scan"},
      {"candidates", &O::candidates, "", 1, kMany, "candidates kept by likelihood-field score, one per place"},
      {"hypotheses", &O::hypotheses, "", 1, kMany, "candidates kept by the scorers, one per place"},
      {"under_constrained_patterns", &O::under_constrained_patterns, "", 1, 1000,
       "patterns with a free parameter looked up per scan"},
      {"under_constrained_below_nat", &O::under_constrained_below_nat, "nat", -kMany, kMany,
       "patterns with a free parameter are looked up if no candidate scores this"},
      {"under_constrained_until_nat", &O::under_constrained_until_nat, "nat", -kMany, kMany,
       "patterns with a free parameter are looked up while no hypothesis has this much, and where there are no others"},
      {"from_stable", &O::from_stable, "", 0, 0, "only stable local features are looked up (Hendrikx 2023)"},
  };
  return all;
}

const Fields<VerificationOptions>& fields_of(const VerificationOptions&) {
  using O = VerificationOptions;
  static const Fields<O> all = {
      {"scans", &O::scans, "", 0, 1000, "scans seen before by which a candidate is verified; 0: none"},
      {"behind_nat", &O::behind_nat, "nat", 0, kMany,
       "a candidate that falls behind the best ones of the time by more is no hypothesis"},
  };
  return all;
}

const Fields<GrowthOptions>& fields_of(const GrowthOptions&) {
  using O = GrowthOptions;
  static const Fields<O> all = {
      {"max_branches", &O::max_branches, "", 1, 1000, "mapped features tried per local feature and hypothesis"},
      {"branch_not_on_map", &O::branch_not_on_map, "", 0, 0,
       "also branch \"not on the map\" when there is a mapped feature"},
      {"max_consecutive_not_on_map", &O::max_consecutive_not_on_map, "", 0, kMany,
       "features in a row that may be not on the map; 0: no limit"},
      {"similar_depth", &O::similar_depth, "", 0, 1000, "leaves that share so many last associations are one; 0: off"},
      {"register_by_associations", &O::register_by_associations, "", 0, 0,
       "pose from associations instead of scan and surfaces"},
      {"registration_horizon", &O::registration_horizon, "", 2, 1000, "last associations that give that pose"},
      {"gate_m", &O::gate_m, "m", 0, 100, "most distance of a local feature from its mapped counterpart"},
      {"gate_rad", &O::gate_rad, "rad", 0, 4, "most angle between a local feature and its mapped counterpart"},
      {"outlier_m", &O::outlier_m, "m", 0, 100, "an association that is farther off is given up"},
      {"outlier_rad", &O::outlier_rad, "rad", 0, 4, "an association that is turned by more is given up"},
  };
  return all;
}

const Fields<TrackingOptions>& fields_of(const TrackingOptions&) {
  using O = TrackingOptions;
  static const Fields<O> all = {
      {"evidence_memory", &O::evidence_memory, "", 0, 1, "share of gathered evidence kept per whole piece of evidence"},
      {"prior_position", &O::prior_position, "", 0, kMany, "weight per scan point of dead reckoning's position"},
      {"prior_heading", &O::prior_heading, "", 0, kMany, "weight per scan point of dead reckoning's heading"},
      {"pose_memory", &O::pose_memory, "", 0, 1,
       "share of what is known of a pose that is kept per whole piece of evidence; 0: the newest scan decides"},
  };
  return all;
}

const Fields<HypothesesOptions>& fields_of(const HypothesesOptions&) {
  using O = HypothesesOptions;
  static const Fields<O> all = {
      {"spawn_nat", &O::spawn_nat, "nat", -kMany, kMany, "log prior of a new hypothesis against clutter"},
      {"prune_nat", &O::prune_nat, "nat", 0, kMany, "a hypothesis that is worse than the best by this ends"},
      {"max_hypotheses", &O::max_hypotheses, "", 1, kMany, "hypotheses that are kept"},
      {"compared_places", &O::compared_places, "", 0, 100, "best places told apart by the beams that differ; 0: none"},
  };
  return all;
}

const Fields<StatusOptions>& fields_of(const StatusOptions&) {
  using O = StatusOptions;
  static const Fields<O> all = {
      {"none_scan_nat", &O::none_scan_nat, "nat", -kMany, kMany,
       "what a scan says for a wrong pose at a place that is not on the map"},
      {"localized_probability", &O::localized_probability, "", 0, 1, "probability that the best place must exceed"},
      {"localized_weight", &O::localized_weight, "", 0, kMany,
       "sum of tempering weights over which the best place must have that probability"},
      {"localized_weight_per_m", &O::localized_weight_per_m, "1/m", 0, kMany,
       "additional tempering weight required per metre of unmapped wall beyond localized_unmapped_m"},
      {"localized_unmapped_m", &O::localized_unmapped_m, "m", 0, kMany,
       "straight walls around the robot that may be missing on the map without further evidence"},
      {"localized_agreement", &O::localized_agreement, "", 0, 1,
       "least share of beams that end on mapped surfaces, of those that end there or pass through, without further "
       "evidence"},
      {"localized_weight_per_share", &O::localized_weight_per_share, "", 0, kMany,
       "additional tempering weight required per unit by which that share is below localized_agreement"},
      {"localized_least_agreement", &O::localized_least_agreement, "", 0, 1, "share below which nothing is localized"},
      {"localized_lead", &O::localized_lead, "", 0, 1, "share of its evidence by which the best place has to lead"},
      {"localized_most_weight", &O::localized_most_weight, "", 0, kMany, "most tempering weight that is ever required"},
      {"localized_within_m", &O::localized_within_m, "m", 0, kMany, "three standard deviations of position"},
      {"localized_within_rad", &O::localized_within_rad, "rad", 0, kMany, "three standard deviations of heading"},
      {"lost_scan_nat", &O::lost_scan_nat, "nat", -kMany, kMany,
       "mean score of the newest scans below which the robot is lost"},
  };
  return all;
}

const Fields<KidnappingOptions>& fields_of(const KidnappingOptions&) {
  using O = KidnappingOptions;
  static const Fields<O> all = {
      {"prior_nat", &O::prior_nat, "nat", -kMany, 0,
       "log prior of a kidnapping where a scan does not continue those before"},
      {"scan_nat", &O::scan_nat, "nat", -kMany, kMany,
       "what a scan says for the place that the robot was kidnapped from"},
      {"alarm_nat", &O::alarm_nat, "nat", 0, kMany,
       "suspicion from which a scan is looked at even if the robot stands"},
  };
  return all;
}

const Fields<RideOptions>& fields_of(const RideOptions&) {
  using O = RideOptions;
  static const Fields<O> all = {
      {"stand_s", &O::stand_s, "s", 0.1, 1000,
       "a robot that stands in a lift for so long may be on any storey that the lift serves"},
  };
  return all;
}

/// Calls `use(name, description, stage)` for every stage, in pipeline order.
template <class Options, class Use>
void for_each_stage(Options& options, Use&& use) {
  use("tempering", "how much a scan counts as independent evidence", options.tempering);
  use("schedule", "when the map is searched", options.schedule);
  use("search", "global search: which patterns are looked up, how many candidates pass", options.search);
  use("verification", "retrospective verification of candidates by scans seen before", options.verification);
  use("growth", "growth of the association tree", options.growth);
  use("tracking", "tracking of hypotheses from scan to scan", options.tracking);
  use("hypotheses", "the set of hypotheses", options.hypotheses);
  use("status", "when a pose is called localized, when lost", options.status);
  use("kidnapping", "kidnap detection", options.kidnapping);
  use("rides", "rides in lifts from storey to storey", options.rides);
}

template <class Stage>
OptionInfo described(const Field<Stage>& field, const Stage& stage) {
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
void set(Stage& stage, const Field<Stage>& field, const nlohmann::json& value, const std::string& where) {
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
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&, &key = name](const auto& f) { return key == f.name; });
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
      stages.back().options.push_back({kRegion, "object", "", nullptr, nullptr, nullptr,
                                       "x_m, y_m, radius_m: where the robot is known to be, roughly"});
  });
  return stages;
}

LocalizerOptions read_localizer_options(const nlohmann::json& stages, const std::string& where) {
  if (!stages.is_object()) throw ConfigError(where + ": " + stages.dump() + ", expected an object of stages");
  LocalizerOptions options;
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
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw ConfigError(where + "/" + name + ": unknown stage, expected one of: " + listed(known));
  return options;
}

}  // namespace opal
