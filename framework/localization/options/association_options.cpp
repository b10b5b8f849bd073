#include "localization/options/association_options.hpp"
#include <opal/common/error.hpp>

#include <limits>
#include <variant>

namespace opal {
namespace {

using Member = std::variant<int AssociationOptions::*, double AssociationOptions::*, bool AssociationOptions::*>;

struct Field {
  const char* name;
  Member member;
  double minimum = 0;
  double maximum = 0;
};

constexpr double kMany = 1e6;

const std::vector<Field>& fields() {
  using O = AssociationOptions;
  static const std::vector<Field> all = {
      {"seed_features", &O::seed_features, 1, 1000},
      {"seed_patterns", &O::seed_patterns, 1, 1000},
      {"seed_loose_patterns", &O::seed_loose_patterns, 1, 1000},
      {"seed_lookup_limit", &O::seed_lookup_limit, 1, kMany},
      {"seed_places", &O::seed_places, 0, kMany},
      {"seed_close_looks", &O::seed_close_looks, 1, kMany},
      {"seed_candidates", &O::seed_candidates, 1, kMany},
      {"seed_hypotheses", &O::seed_hypotheses, 1, kMany},
      {"seed_every_m", &O::seed_every_m, 0, 1000},
      {"seed_every_rad", &O::seed_every_rad, 0, 1000},
      {"seed_every_when_localized", &O::seed_every_when_localized, 1, kMany},
      {"seed_every_when_likely", &O::seed_every_when_likely, 1, kMany},
      {"seed_places_per_chance", &O::seed_places_per_chance, 0, kMany},
      {"likely_probability", &O::likely_probability, 0, 1},
      {"loose_below_nat", &O::loose_below_nat, -kMany, kMany},
      {"loose_until_nat", &O::loose_until_nat, -kMany, kMany},
      {"slide_step_m", &O::slide_step_m, 0.01, 10},
      {"birth_nat", &O::birth_nat, -kMany, kMany},
      {"hindsight_scans", &O::hindsight_scans, 0, 1000},
      {"hindsight_behind_nat", &O::hindsight_behind_nat, 0, kMany},
      {"seed_from_stable", &O::seed_from_stable},
      {"max_branches", &O::max_branches, 1, 1000},
      {"branch_not_on_map", &O::branch_not_on_map},
      {"max_consecutive_not_on_map", &O::max_consecutive_not_on_map, 0, kMany},
      {"similar_depth", &O::similar_depth, 0, 1000},
      {"register_by_associations", &O::register_by_associations},
      {"registration_horizon", &O::registration_horizon, 2, 1000},
      {"gate_m", &O::gate_m, 0, 100},
      {"gate_rad", &O::gate_rad, 0, 4},
      {"outlier_m", &O::outlier_m, 0, 100},
      {"outlier_rad", &O::outlier_rad, 0, 4},
      {"memory", &O::memory, 0, 1},
      {"encounter_memory", &O::encounter_memory, 0, 1},
      {"novelty_m", &O::novelty_m, 0.001, 1000},
      {"novelty_rad", &O::novelty_rad, 0.001, 1000},
      {"least_novelty", &O::least_novelty, 0, 1},
      {"track_prior_position", &O::track_prior_position, 0, kMany},
      {"track_prior_heading", &O::track_prior_heading, 0, kMany},
      {"track_memory", &O::track_memory, 0, 1},
      {"track_jump_m", &O::track_jump_m, 0.001, kMany},
      {"track_search", &O::track_search, 0, kMany},
      {"merge_m", &O::merge_m, 0, 100},
      {"merge_rad", &O::merge_rad, 0, 4},
      {"prune_nat", &O::prune_nat, 0, kMany},
      {"max_hypotheses", &O::max_hypotheses, 1, kMany},
      {"none_nat", &O::none_nat, -kMany, kMany},
      {"localized_probability", &O::localized_probability, 0, 1},
      {"localized_novelty", &O::localized_novelty, 0, kMany},
      {"localized_novelty_per_m", &O::localized_novelty_per_m, 0, kMany},
      {"localized_unmapped_m", &O::localized_unmapped_m, 0, kMany},
      {"localized_most_novelty", &O::localized_most_novelty, 0, kMany},
      {"none_scan_nat", &O::none_scan_nat, -kMany, kMany},
      {"lost_scan_nat", &O::lost_scan_nat, -kMany, kMany},
      {"carried_nat", &O::carried_nat, -kMany, 0},
      {"carried_unseen_nat", &O::carried_unseen_nat, -kMany, 0},
      {"carried_match_share", &O::carried_match_share, 0, 1},
      {"carried_drop", &O::carried_drop, 0, 1},
      {"carried_place_nat", &O::carried_place_nat, -kMany, 0},
      {"carried_scan_nat", &O::carried_scan_nat, -kMany, kMany},
      {"carried_most_nat", &O::carried_most_nat, 0, kMany},
      {"carried_search_nat", &O::carried_search_nat, 0, kMany},
      {"carried_alarm_nat", &O::carried_alarm_nat, 0, kMany},
  };
  return all;
}

[[noreturn]] void refuse(const std::string& where, const nlohmann::json& found, const std::string& expected) {
  throw ConfigError(where + ": " + found.dump() + ", expected " + expected);
}

std::string number_text(double value) { return nlohmann::json(value).dump(); }

template <class T>
T checked(const Field& field, const nlohmann::json& value, const std::string& where) {
  const bool integer = std::is_same_v<T, int>;
  const std::string expected = std::string(integer ? "an integer" : "a number") + " from " +
                               number_text(field.minimum) + " to " + number_text(field.maximum);
  if (integer ? !value.is_number_integer() : !value.is_number()) refuse(where, value, expected);
  const double number = value.get<double>();
  if (!(number >= field.minimum && number <= field.maximum)) refuse(where, value, expected);
  return static_cast<T>(number);
}

void set(AssociationOptions& options, const Field& field, const nlohmann::json& value,
         const std::string& where) {
  if (const auto* member = std::get_if<int AssociationOptions::*>(&field.member))
    options.**member = checked<int>(field, value, where);
  else if (const auto* real = std::get_if<double AssociationOptions::*>(&field.member))
    options.**real = checked<double>(field, value, where);
  else if (!value.is_boolean())
    refuse(where, value, "true or false");
  else
    options.*std::get<bool AssociationOptions::*>(field.member) = value.get<bool>();
}

RegionPrior read_region(const nlohmann::json& value, const std::string& where) {
  const Field coordinate{"", &AssociationOptions::gate_m, -1e6, 1e6};
  const Field radius{"", &AssociationOptions::gate_m, 1e-3, 1e6};
  if (!value.is_object() || value.size() != 3 || !value.contains("x_m") || !value.contains("y_m") ||
      !value.contains("radius_m"))
    refuse(where, value, "an object with x_m, y_m and radius_m");
  return {{checked<double>(coordinate, value["x_m"], where + "/x_m"),
           checked<double>(coordinate, value["y_m"], where + "/y_m")},
          checked<double>(radius, value["radius_m"], where + "/radius_m")};
}

}  // namespace

AssociationOptions read_association_options(const nlohmann::json& options, const std::string& where) {
  if (!options.is_object()) refuse(where, options, "an object of options");
  AssociationOptions read;
  for (const auto& [name, value] : options.items()) {
    if (name == "region") {
      read.region = read_region(value, where + "/region");
      continue;
    }
    const Field* field = nullptr;
    for (const Field& known : fields())
      if (name == known.name) field = &known;
    if (!field) throw ConfigError(where + "/" + name + ": is no association option");
    set(read, *field, value, where + "/" + name);
  }
  return read;
}

}  // namespace opal
