#include "deployment/stage_fields.hpp"

namespace opal {

const StageFields<SearchScheduleOptions>& fields_of(const SearchScheduleOptions&) {
  using O = SearchScheduleOptions;
  static const StageFields<O> all = {
      {"every_m", &O::every_m, "m", 0, 1000,
       "Distance to drive after which the map may be searched again. every_when_localized and every_when_likely count "
       "these chances."},
      {"every_rad", &O::every_rad, "rad", 0, 1000,
       "Angle to turn after which the map may be searched again, even if every_m has not been driven."},
      {"every_when_localized", &O::every_when_localized, "", 1, kUnlimited,
       "While the robot is localized, the map is searched at one of so many chances. 1: at each."},
      {"every_when_likely", &O::every_when_likely, "", 1, kUnlimited,
       "While the best place is likely but the robot is not localized, the map is searched at one of so many chances. "
       "1: at each."},
      {"likely_probability", &O::likely_probability, "", 0, 1,
       "Probability of the best place above which it is called likely. Below it, every chance is a search."},
  };
  return all;
}

const StageFields<SearchOptions>& fields_of(const SearchOptions&) {
  using O = SearchOptions;
  static const StageFields<O> all = {
      {"patterns", &O::patterns, "", 1, 1000,
       "Most observed patterns of each template that are looked up in the map per search. The best supported ones are "
       "taken."},
      {"lookup_limit", &O::lookup_limit, "", 1, kUnlimited,
       "Most candidates per search that the patterns of one template give. The patterns that are rarest on the map "
       "are taken first, at least one."},
      {"places", &O::places, "", 0, kUnlimited,
       "Most candidates per search that the patterns of all templates give together, rarest first. The three rarest "
       "may give five times as many. 0: any number."},
      {"places_per_scan", &O::places_per_scan, "", 0, kUnlimited,
       "Most candidates that are looked at per scan. A search that has more goes on at the next scans, so the time "
       "per scan does not grow with the building. 0: any number."},
      {"close_looks", &O::close_looks, "", 1, kUnlimited,
       "First filter of candidates: so many go on, those where a few points of the scan lie best. They are then "
       "judged by all points of a thinned scan."},
      {"candidates", &O::candidates, "", 1, kUnlimited,
       "Second filter of candidates: so many places go on, those with the best likelihood-field score. They are then "
       "aligned to the map and judged by the scorers."},
      {"hypotheses", &O::hypotheses, "", 1, kUnlimited,
       "Last filter of candidates: so many places go on, those with the best evidence. They then may become "
       "hypotheses."},
      {"under_constrained_patterns", &O::under_constrained_patterns, "", 1, 1000,
       "Most observed patterns of each template with a free direction, as one wall has, that are looked up per "
       "search."},
      {"under_constrained_below_nat", &O::under_constrained_below_nat, "nat", -kUnlimited, kUnlimited,
       "Patterns with a free direction are looked up only if no candidate of the same search has this much evidence."},
      {"under_constrained_until_nat", &O::under_constrained_until_nat, "nat", -kUnlimited, kUnlimited,
       "Patterns with a free direction are looked up only while no hypothesis has gathered this much evidence. Until "
       "the robot is localized, they are also looked up where no other patterns are seen."},
      {"from_stable", &O::from_stable, "", 0, 0,
       "Patterns consist of stable features of the local map only, as in Hendrikx (2023). Otherwise they consist of "
       "the features of the newest scan."},
  };
  return all;
}

const StageFields<VerificationOptions>& fields_of(const VerificationOptions&) {
  using O = VerificationOptions;
  static const StageFields<O> all = {
      {"scans", &O::scans, "", 0, 1000,
       "Number of earlier scans that are kept, each a whole piece of evidence. They judge every candidate. 0: none."},
      {"behind_nat", &O::behind_nat, "nat", 0, kUnlimited,
       "A candidate is dropped if the earlier scans give it so much less evidence than they gave the best hypothesis "
       "of their time. localized_lead of the stage status may raise this limit."},
  };
  return all;
}

}  // namespace opal
