#pragma once

#include <opal/common/geometry.hpp>

#include <string>

namespace opal {

/// Numbers as people read them: always with a point, no "-0.00", and no endless digits for absurd values.
std::string fixed_text(double value, int decimals);

inline std::string metres_text(double metres) { return fixed_text(metres, 2) + " m"; }
inline std::string seconds_text(double seconds) { return fixed_text(seconds, 1) + " s"; }
inline std::string nat_text(double nat) { return fixed_text(nat, 2) + " nat"; }
inline std::string probability_text(double probability) { return fixed_text(probability, 3); }
inline std::string percent_text(double share) { return fixed_text(100 * share, 0) + " %"; }

/// "(12.10, 3.40)" [m]
std::string place_text(const Point& place);
/// "(12.10, 3.40), heading 31.0 deg"
std::string pose_text(const Pose2& pose);

/// "3 patterns", "1 pattern"
std::string count_text(std::size_t count, const std::string& singular);

}  // namespace opal
