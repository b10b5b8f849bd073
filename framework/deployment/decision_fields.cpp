#include "deployment/stage_fields.hpp"

namespace opal {

const StageFields<StatusOptions>& fields_of(const StatusOptions&) {
  using O = StatusOptions;
  static const StageFields<O> all = {
      {"none_scan_nat", &O::none_scan_nat, "nat", -kUnlimited, kUnlimited,
       "Evidence per scan of weight 1 that a wrong pose gathers where the robot is not on the map. A hypothesis must "
       "gather more to be probable."},
      {"localized_probability", &O::localized_probability, "", 0, 1,
       "Probability that the best place must exceed to be called localized."},
      {"localized_weight", &O::localized_weight, "", 0, kUnlimited,
       "Tempering weight of scans, summed up, during which the best place must hold that probability without a break. "
       "What is asked for grows by localized_weight_per_m and localized_weight_per_share."},
      {"localized_weight_per_m", &O::localized_weight_per_m, "1/m", 0, kUnlimited,
       "Further tempering weight per metre of straight wall beyond localized_unmapped_m that the map lacks."},
      {"localized_unmapped_m", &O::localized_unmapped_m, "m", 0, kUnlimited,
       "Length of straight walls around the robot that may be missing on the map without further evidence."},
      {"localized_agreement", &O::localized_agreement, "", 0, 1,
       "Share of beams that end on mapped surfaces, of all that end on them or pass through them. Below this share, "
       "further evidence is asked for."},
      {"localized_weight_per_share", &O::localized_weight_per_share, "", 0, kUnlimited,
       "Further tempering weight per unit by which the share that localized_agreement asks for is missed."},
      {"localized_least_agreement", &O::localized_least_agreement, "", 0, 1,
       "Share of beams that end on mapped surfaces below which no evidence is enough: the map is of another place."},
      {"localized_drive_agreement", &O::localized_drive_agreement, "", 0, 1,
       "Share of beams that end on mapped surfaces, over the newest twenty or so pieces of evidence wherever the best "
       "place was, below which nothing is localized: the map is not as the building is. 0: any share will do."},
      {"localized_lead", &O::localized_lead, "", 0, 1,
       "Share of its own evidence by which the best place must lead over every other place. 0: any lead is enough."},
      {"localized_lead_nat", &O::localized_lead_nat, "nat", 0, kUnlimited,
       "Most that the best place must ever lead over another place, however much evidence it has."},
      {"localized_most_weight", &O::localized_most_weight, "", 0, kUnlimited,
       "Most tempering weight that is ever asked for, whatever the map lacks. localized_weight, if that is more."},
      {"localized_within_m", &O::localized_within_m, "m", 0, kUnlimited,
       "Most that the position of a localized robot may be uncertain by, as three standard deviations."},
      {"localized_within_rad", &O::localized_within_rad, "rad", 0, kUnlimited,
       "Most that the heading of a localized robot may be uncertain by, as three standard deviations."},
      {"lost_scan_nat", &O::lost_scan_nat, "nat", -kUnlimited, kUnlimited,
       "A robot that was localized is lost if its newest five or so scans score less than this on average."},
  };
  return all;
}

const StageFields<KidnappingOptions>& fields_of(const KidnappingOptions&) {
  using O = KidnappingOptions;
  static const StageFields<O> all = {
      {"prior_nat", &O::prior_nat, "nat", -kUnlimited, 0,
       "Log prior that the robot was kidnapped, once a scan does not continue what was seen before. A larger value "
       "suspects a kidnapping sooner."},
      {"scan_nat", &O::scan_nat, "nat", -kUnlimited, kUnlimited,
       "Score of a scan below which it speaks for a kidnapping: what a scan says for the place where the robot no "
       "longer is."},
      {"alarm_nat", &O::alarm_nat, "nat", 0, kUnlimited,
       "A single scan that scores so much less than what is expected is looked at even if the robot stands still."},
      {"doubted_share", &O::doubted_share, "", 0, 1,
       "A scan that says less than half of what scans said may be of a kidnapped robot if it shows less than this "
       "share "
       "of what is usually seen again. 0: it does not matter what the scan says."},
      {"doubted_weight", &O::doubted_weight, "", 0, kUnlimited,
       "After a scan that does not continue what was seen before, scans are held against what earlier ones said for so "
       "many pieces of new evidence. 0: until one of them says as much."},
  };
  return all;
}

const StageFields<RideOptions>& fields_of(const RideOptions&) {
  using O = RideOptions;
  static const StageFields<O> all = {
      {"stand_s", &O::stand_s, "s", 0.1, 1000,
       "Time that a robot must stand still in a lift of the map before it may be on any storey that the lift serves."},
  };
  return all;
}

}  // namespace opal
