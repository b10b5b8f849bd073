#pragma once

#include "learning/drive_legs.hpp"

#include <opal/localization/localizer.hpp>

namespace opal {

/// The way between two legs along which nothing was followed, as odometry and scan matching tell it.
/// @param samples  of its keyframes: the last one of the leg before, what came between, the first one of the leg after.
/// @param start, end  poses of the first and the last sample, frame `map`.
/// @return none if it does not lead from one to the other; what it is off is shared out along it.
std::optional<DriveLeg> gap_leg(const LocalizerParts& parts, std::span<const Sample> samples, const Pose2& start,
                                const Pose2& end);

}  // namespace opal
