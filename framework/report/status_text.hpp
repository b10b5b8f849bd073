#pragma once

#include <span>
#include <string>

namespace opal {

/// A status for people. Where a place is found and must still prove itself, this says so: `searching` with a
/// probability of 1.000 reads like a contradiction.
/// @param probability  of the best place; 0 if there is none.
std::string status_text(const std::string& status, double probability);

/// Why it is no other status, for people; empty if it is `localized`, or nothing is known.
/// @param why  as the estimate says it. @param of_sensor  what the drive tells of the sensor: where `why` is one of
/// these, more evidence will not help.
std::string reason_text(const std::string& status, const std::string& why, std::span<const std::string> of_sensor);

}  // namespace opal
