#include "encounters.hpp"

#include <algorithm>

namespace {

bool comes_before(const Amounts::Entry& entry, int thing) { return entry.thing < thing; }

}  // namespace

double Amounts::of(int thing) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), thing, comes_before);
  return at != entries_.end() && at->thing == thing ? at->amount : 0;
}

void Amounts::add(int thing, double amount) {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), thing, comes_before);
  if (at != entries_.end() && at->thing == thing)
    at->amount += amount;
  else
    entries_.insert(at, {thing, amount});
}

void Amounts::fade(double keep) {
  constexpr double kNothing = 0.01;
  for (Entry& entry : entries_) entry.amount *= keep;
  std::erase_if(entries_, [](const Entry& entry) { return entry.amount < kNothing; });
}

namespace {

constexpr Amounts Encounters::*kKinds[] = {&Encounters::cells_met,   &Encounters::lines_met,
                                           &Encounters::ends_met,    &Encounters::lines_ended,
                                           &Encounters::objects_met, &Encounters::objects_passed};

}  // namespace

void Encounters::fade(double keep) {
  for (Amounts Encounters::*kind : kKinds) (this->*kind).fade(keep);
}

void Encounters::add(const Encounters& newer, double weight) {
  fade(1);  // forgets what has nearly vanished
  for (Amounts Encounters::*kind : kKinds)
    for (const Amounts::Entry& entry : (newer.*kind).entries()) (this->*kind).add(entry.thing, weight * entry.amount);
}
