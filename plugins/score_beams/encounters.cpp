#include "encounters.hpp"

namespace opal::score_beams {
namespace {

template <class Thing>
void add_all(AmountsBy<Thing>& to, const AmountsBy<Thing>& newer, double weight) {
  for (const auto& [thing, amount] : newer.entries()) to.add(thing, weight * amount);
}

}  // namespace

void Encounters::fade(double keep) {
  cells_met.fade(keep);
  lines_met.fade(keep);
  ends_met.fade(keep);
  lines_ended.fade(keep);
  objects_met.fade(keep);
  objects_passed.fade(keep);
}

void Encounters::add(const Encounters& newer, double weight) {
  fade(1);  // forgets what has nearly vanished
  add_all(cells_met, newer.cells_met, weight);
  add_all(lines_met, newer.lines_met, weight);
  add_all(ends_met, newer.ends_met, weight);
  add_all(lines_ended, newer.lines_ended, weight);
  add_all(objects_met, newer.objects_met, weight);
  add_all(objects_passed, newer.objects_passed, weight);
}

}  // namespace opal::score_beams
