#include "change_detector.hpp"

#include <algorithm>
#include <cmath>

namespace opal {

void ChangeDetector::add(int keyframe, double scan_nat, double gathered_nat, double novelty, bool established) {
  if (established || suspicion_nat_ > 0)
    suspicion_nat_ = std::clamp(suspicion_nat_ + options_.carried_scan_nat - scan_nat, 0.0, options_.carried_most_nat);
  if (suspicion_nat_ == 0)
    last_good_ = {keyframe, gathered_nat};
  else
    last_good_.nat *= 1 - novelty * (1 - options_.memory);
}

void ChangeDetector::reset() {
  suspicion_nat_ = 0;
  last_good_ = {};
}

double ChangeDetector::probability() const {
  return 1 / (1 + std::exp(-(suspicion_nat_ + options_.carried_nat)));
}

bool ChangeDetector::alarming(double scan_nat) const {
  return scan_nat < options_.carried_scan_nat - options_.carried_alarm_nat;
}

std::optional<ChangeDetector::Break> ChangeDetector::suspected() const {
  if (suspicion_nat_ < options_.carried_search_nat) return std::nullopt;
  return Break{last_good_.keyframe, last_good_.nat + options_.carried_nat + options_.carried_place_nat};
}

}  // namespace opal
