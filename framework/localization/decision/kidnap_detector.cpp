#include "localization/decision/kidnap_detector.hpp"

#include <algorithm>
#include <cmath>

namespace opal {

void KidnapDetector::add(const Evidence& seen) {
  if (seen.match_share < options_.carried_match_share) discontinued_ = seen.keyframe;
  if (seen.established || suspicion_nat_ > 0)
    suspicion_nat_ =
        std::clamp(suspicion_nat_ + wanted_nat() - seen.scan_nat, 0.0, options_.carried_most_nat);
  if (suspicion_nat_ == 0) {
    constexpr double kMemory = 0.9;
    usual_nat_ = kMemory * usual_nat_ + (1 - kMemory) * seen.scan_nat;
    last_good_ = {seen.keyframe, seen.gathered_nat};
  } else {
    last_good_.nat *= 1 - seen.tempering_weight * (1 - options_.memory);
  }
}

void KidnapDetector::reset() {
  suspicion_nat_ = 0;
  usual_nat_ = 0;
  last_good_ = {};
  discontinued_ = -2;
}

double KidnapDetector::share_of_usual_nat() const {
  return std::max(options_.carried_scan_nat, options_.carried_drop * usual_nat_);
}

double KidnapDetector::wanted_nat() const { return discontinued() ? share_of_usual_nat() : options_.carried_scan_nat; }

double KidnapDetector::probability() const {
  const double prior_nat = discontinued() ? options_.carried_nat : options_.carried_unseen_nat;
  return 1 / (1 + std::exp(-(suspicion_nat_ + prior_nat)));
}

bool KidnapDetector::alarming(double scan_nat) const {
  return scan_nat < share_of_usual_nat() - options_.carried_alarm_nat;
}

std::optional<KidnapDetector::Break> KidnapDetector::suspected() const {
  if (suspicion_nat_ < options_.carried_search_nat || !discontinued()) return std::nullopt;
  return Break{last_good_.keyframe, last_good_.nat + options_.carried_nat + options_.carried_place_nat};
}

}  // namespace opal
