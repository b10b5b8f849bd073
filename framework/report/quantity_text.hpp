#pragma once

#include <opal/common/geometry.hpp>

#include <string>

namespace opal {

/// Numbers as people read them: always with a point, no "-0.00", and no endless digits for absurd values; "-" for what
/// is no number, "∞" and "-∞" for what is infinite.
std::string fixed_text(double value, int decimals);

inline std::string metres_text(double metres) { return fixed_text(metres, 2) + " m"; }
inline std::string seconds_text(double seconds) { return fixed_text(seconds, 1) + " s"; }
inline std::string nat_text(double nat) { return fixed_text(nat, 2) + " nat"; }
inline std::string probability_text(double probability) { return fixed_text(probability, 3); }
inline std::string percent_text(double share, int decimals = 0) { return fixed_text(100 * share, decimals) + " %"; }

/// "1.2 to 3.4"
std::string interval_text(double low, double high, int decimals);
/// "2.0 (1.2 to 3.4)"
std::string within_text(double value, double low, double high, int decimals);
/// "0.004", "< 0.0001"
std::string p_text(double p);

/// "(12.10, 3.40)" [m]
std::string place_text(const Point& place);
/// "(12.10, 3.40), heading 31.0 deg"
std::string pose_text(const Pose2& pose);

}  // namespace opal
