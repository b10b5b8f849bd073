#include "scorer.hpp"

#include <algorithm>
#include <array>

using opal::Point;

struct BeamScorer::Tally {
  double value = 0;
  double hits = 0, shorts = 0, throughs = 0;
  int beams = 0;

  /// The beams that pass through one mapped object.
  struct Passed {
    int object = -1;
    double there = 0;   ///< what they are worth if the object is there,
    double absent = 0;  ///< and if it is not
  };
  std::array<Passed, 24> passed;
  std::size_t objects = 0;

  /// The entry of an object; those beyond what there is room for share the last one.
  Passed& through(int object) {
    for (std::size_t k = 0; k < objects; ++k)
      if (passed[k].object == object) return passed[k];
    if (objects < passed.size()) passed[objects++] = {object, 0, 0};
    return passed[objects - 1];
  }
  /// Each object is taken to be there or not, whichever explains its beams better at the price of an absence.
  double passed_value(double price) const {
    double sum = 0;
    for (std::size_t k = 0; k < objects; ++k) sum += std::max(passed[k].there, passed[k].absent - price);
    return sum;
  }
};

BeamScorer::BeamScorer(const nlohmann::json& options)
    : weight_nat_(options.at("weight_nat")),
      short_(options.at("short")),
      through_(options.at("through")),
      free_through_(options.at("free_through")),
      sigma_m_(options.at("sigma_m")),
      sigma_per_m_(options.at("sigma_per_m")),
      margin_m_(options.at("margin_m")),
      margin_per_m_(options.at("margin_per_m")),
      free_range_m_(options.at("free_range_m")),
      absence_(options.at("absence")),
      floor_(options.at("floor")),
      min_beams_(options.at("min_beams")) {}

void BeamScorer::judge_hit(const opal::MapView& map, const Point& eye, const Point& end, Tally& tally) const {
  const double range = (end - eye).norm();
  double hit = 0;
  if (const int number = map.nearest_facing(end, end - eye); number >= 0) {
    const double sigma = sigma_m_ + sigma_per_m_ * range;
    const double z = map.surface(number).distance_m(end) / sigma;
    hit = std::exp(-0.5 * z * z);
  }
  const auto wall = map.first_crossing(eye, end, margin_at(range));
  ++tally.beams;
  if (wall.feature >= 0) {
    ++tally.throughs;
    Tally::Passed& passed = tally.through(map.feature(wall.feature).object);
    passed.there += through_ * (1 - 0.3 * hit);
    passed.absent += hit + (1 - hit) * short_;
  } else {
    tally.hits += hit;
    tally.shorts += 1 - hit;
    tally.value += hit + (1 - hit) * short_;
  }
}

void BeamScorer::judge_free(const opal::MapView& map, const Point& eye, double bearing_rad, double range_max_m,
                            Tally& tally) const {
  const double range = std::min(range_max_m, free_range_m_);
  const Point end = eye + range * opal::unit_vector(bearing_rad);
  ++tally.beams;
  const auto wall = map.first_crossing(eye, end, margin_at(range));
  if (wall.feature < 0) return;
  ++tally.throughs;
  tally.through(map.feature(wall.feature).object).there += free_through_;
}

opal::Score BeamScorer::score(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                              const opal::MapView& map) const {
  const opal::Pose2 T_map_base = hypothesis.T_map_local * observation.local_map.T_local_base();
  const Point eye = T_map_base * observation.laser_position;
  Tally tally;
  for (const Point& point : observation.points) judge_hit(map, eye, T_map_base * point, tally);
  for (double bearing : observation.free_bearings_rad)
    judge_free(map, eye, bearing + T_map_base.heading_rad(), observation.range_max_m, tally);
  const double n = std::max(tally.beams, min_beams_);
  const double value = tally.value + tally.passed_value(absence_ * n);
  const double share = std::max(value / n, floor_);
  return {weight_nat_ * share,
          {},
          {{"hit", tally.hits / n}, {"short", tally.shorts / n}, {"through", tally.throughs / n}}};
}
