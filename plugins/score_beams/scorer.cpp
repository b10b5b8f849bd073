#include "scorer.hpp"

#include <algorithm>

namespace opal::score_beams {
namespace {

/// What is seen again and again is worth ever less: `enough` of it count half of `enough`, and any amount less than
/// `enough`.
double worth(double amount, double enough) { return amount / (1 + amount / enough); }

}  // namespace

struct BeamScorer::Tally {
  SumsBy<EvidenceCell> matched;        ///< beams that end on a mapped surface
  SumsBy<WallLineNumber> lines;        ///< the same, with those beyond an absent object
  SumsBy<FaceEndNumber> ends;          ///< ends of faces that were seen where the map has one
  SumsBy<WallLineNumber> ended_lines;  ///< what these sightings are worth, by the mapped face's line
  SumsBy<MapObjectNumber> ended;       ///< beams that end on a mapped surface of it
  SumsBy<MapObjectNumber> passed;      ///< beams that pass through it
  int beams = 0;
  double hits = 0, hits_behind = 0, other_side = 0, early = 0, throughs = 0, free_throughs = 0;
};

BeamScorer::BeamScorer(const nlohmann::json& options)
    : match_(options.at("match_nat")),
      line_(options.at("line_nat")),
      enough_(options.at("enough")),
      end_(options.at("end_nat")),
      enough_sightings_(options.at("enough_sightings")),
      enough_ends_(options.at("enough_ends")),
      hit_(options.at("hit_nat")),
      early_(options.at("early_nat")),
      absent_(options.at("absent_nat")),
      conflict_(options.at("conflict_nat")),
      through_(options.at("through_nat")),
      free_through_(options.at("free_through_nat")),
      sigma_m_(options.at("sigma_m")),
      sigma_per_m_(options.at("sigma_per_m")),
      margin_m_(options.at("margin_m")),
      margin_per_m_(options.at("margin_per_m")),
      other_side_m_(options.at("other_side_m")),
      ahead_m_(options.at("ahead_m")),
      free_range_m_(options.at("free_range_m")),
      floor_(options.at("floor_nat")),
      encounter_memory_(options.at("encounter_memory")),
      end_gate_{options.at("end_along_m"), options.at("end_across_m"), options.at("end_angle_rad")},
      min_beams_(options.at("min_beams")) {}

double BeamScorer::likelihood_field(double distance_m, double range_m) const {
  const double z = distance_m / (sigma_m_ + sigma_per_m_ * range_m);
  return std::exp(-0.5 * z * z);
}

void BeamScorer::judge_return(const MapView& map, const Point& eye, const Point& end, EvidenceCell evidence_cell,
                              Tally& tally) const {
  constexpr double kLeast = 0.05, kStepBack_m = 0.02, kCrossed_m = 0.1;
  const double range = (end - eye).norm();
  const MapFeatureNumber nearest = map.nearest_facing(end, end - eye);
  const double hit = nearest.exists() ? likelihood_field(map.surface(nearest).distance_m(end), range) : 0;
  ++tally.beams;
  if (hit > kLeast) tally.lines.add(map.surface(nearest).line, hit);
  const auto wall = map.first_crossing(eye, end, margin_at(range));
  if (wall.feature.exists()) {
    constexpr double kExcused = 0.7;  // what lies behind a surface that is not there may well be mapped, too
    tally.throughs += 1;
    tally.hits_behind += hit;
    tally.passed.add(map.surface(wall.feature).object, 1 - kExcused * hit);
    return;
  }
  tally.hits += hit;
  if (hit > kLeast) {
    tally.matched.add(evidence_cell, hit);
    tally.ended.add(map.surface(nearest).object, hit);
  }
  if (hit > 1 - kLeast) return;
  const Point direction = (end - eye) / range;
  const auto next = map.first_crossing(end - kStepBack_m * direction, end + ahead_m_ * direction, kCrossed_m);
  if (!next.feature.exists()) return;
  if (!next.from_behind)
    tally.early += 1 - hit;
  else if (next.range_m < other_side_m_) {
    tally.other_side += 1 - hit;
    tally.matched.add(evidence_cell, 1 - hit);
    tally.lines.add(map.surface(next.feature).line, 1 - hit);
  }
}

/// Where a wall stops is hardly anywhere met by chance: false places have walls where there are walls, but they end
/// elsewhere.
void BeamScorer::judge_ends(const MapView& map, const Pose2& T_map_base, const Feature& seen, const Encounters& before,
                            Tally& tally) const {
  const auto* face = std::get_if<Segment>(&seen.geometry);
  if (!face) return;
  for (const Tip tip : {Tip::begin, Tip::end}) {
    const bool at_begin = tip == Tip::begin;
    if (!seen.true_end[at_begin ? 0 : 1]) continue;
    const FaceEnd met = before.face_ends->nearest(T_map_base * (at_begin ? face->begin : face->end),
                                                  T_map_base.rotate(face->direction()), tip, end_gate_);
    if (!met.face.exists()) continue;
    const double known = before.ends_met.of(met.number()) + tally.ends.of(met.number()),
                 fresh = std::exp(-2 * met.gates * met.gates);
    tally.ends.add(met.number(), fresh);
    tally.ended_lines.add(map.surface(met.face).line,
                          worth(known + fresh, enough_sightings_) - worth(known, enough_sightings_));
  }
}

void BeamScorer::judge_free(const MapView& map, const Point& eye, double bearing_rad, double range_max_m,
                            Tally& tally) const {
  const double range = std::min(range_max_m, free_range_m_);
  const Point end = eye + range * unit_vector(bearing_rad);
  ++tally.beams;
  if (map.first_crossing(eye, end, margin_at(range)).feature.exists()) tally.free_throughs += 1;
}

template <class Thing>
double BeamScorer::news(const SumsBy<Thing>& beams, double each, double enough, const AmountsBy<Thing>& before,
                        AmountsBy<Thing>& now) {
  double total = 0;
  beams.each([&](Thing thing, double count) {
    const double known = before.of(thing), fresh = each * count;
    total += worth(known + fresh, enough) - worth(known, enough);
    now.add(thing, fresh);
  });
  return total;
}

/// Share of beams that pass through objects on which others end, and the other way round. An object that is not there
/// is passed through wherever it is looked at, one that is there nowhere; if it is both, the pose is wrong.
double BeamScorer::conflict(const Tally& tally, double each, const Encounters& before) const {
  double beams = 0;
  using Beams = SumsBy<MapObjectNumber>;
  using Before = AmountsBy<MapObjectNumber>;
  const auto add = [&](const Beams& these, const Before& these_before, const Beams& others,
                       const Before& others_before) {
    these.each([&](MapObjectNumber object, double count) {
      const double against = others_before.of(object) + each * others.of(object);
      beams += count * against / (against + these_before.of(object) + each * count);
    });
  };
  add(tally.passed, before.objects_passed, tally.ended, before.objects_met);
  add(tally.ended, before.objects_met, tally.passed, before.objects_passed);
  return beams * each / 100;
}

BeamScorer::Tally BeamScorer::compare(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                                      const Encounters& before) const {
  const Pose2 T_map_base = observation.T_map_base(hypothesis.T_map_local);
  Tally tally;
  for (const ObservedScan& scan : observation.scans) {
    const Point eye = T_map_base * scan.laser_position;
    for (std::size_t k = 0; k < scan.points.size(); ++k)
      judge_return(map, eye, T_map_base * scan.points[k], scan.evidence_cells[k], tally);
    for (double bearing : scan.free_bearings_rad)
      judge_free(map, eye, bearing + T_map_base.heading_rad(), scan.range_max_m, tally);
  }
  if (end_ > 0)
    for (const Feature& seen : observation.features) judge_ends(map, T_map_base, seen, before, tally);
  return tally;
}

std::unique_ptr<ScorerMemory> BeamScorer::new_memory(const MapView& map) const {
  auto nothing_met = std::make_unique<Encounters>();
  nothing_met->face_ends = std::make_shared<const FaceEnds>(end_ > 0 ? FaceEnds::of(map) : FaceEnds());
  return nothing_met;
}

void BeamScorer::remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const {
  static_cast<Encounters&>(memory).add(static_cast<const Encounters&>(seen), weight);
}

void BeamScorer::fade(ScorerMemory& memory, double weight) const {
  static_cast<Encounters&>(memory).fade(kept_share(weight, encounter_memory_));
}

Score BeamScorer::score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                        const ScorerMemory* memory) const {
  const auto& before = static_cast<const Encounters&>(*memory);
  const Tally tally = compare(hypothesis, observation, map, before);
  // Lasers that look elsewhere tell as much each as one alone does.
  const auto lasers = static_cast<double>(std::max<std::size_t>(1, observation.scans.size()));
  const double n = std::max<double>(tally.beams / lasers, min_beams_), each = 100 / n;
  const auto seen = std::make_shared<Encounters>();
  Encounters& now = *seen;
  const double matched = news(tally.matched, each, enough_, before.cells_met, now.cells_met);
  const double lines = news(tally.lines, each, enough_, before.lines_met, now.lines_met);
  const double ends = news(tally.ended_lines, 1, enough_ends_, before.lines_ended, now.lines_ended);
  const double passed = news(tally.passed, each, enough_, before.objects_passed, now.objects_passed);
  const double met = tally.hits + tally.hits_behind + tally.other_side;
  tally.ended.each([&](MapObjectNumber object, double count) { now.objects_met.add(object, each * count); });
  tally.ends.each([&](FaceEndNumber end, double sightings) { now.ends_met.add(end, sightings); });
  const double nat = match_ * matched + line_ * lines + end_ * ends - absent_ * passed -
                     conflict_ * conflict(tally, each, before) +
                     (hit_ * met - early_ * tally.early - through_ * (tally.throughs - tally.hits_behind) -
                      free_through_ * tally.free_throughs) /
                         n;
  const double throughs = tally.throughs + tally.free_throughs, all = n * lasers;
  return {
      std::max(nat, floor_),
      {},
      {{"hit", tally.hits / all}, {"short", (tally.beams - tally.hits - throughs) / all}, {"through", throughs / all}},
      seen};
}

}  // namespace opal::score_beams
