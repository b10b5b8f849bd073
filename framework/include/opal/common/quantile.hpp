#pragma once

#include <opal/common/export.hpp>

#include <optional>
#include <span>
#include <vector>

namespace opal {

/// The value below which a share of all lie, interpolated linearly (Hyndman and Fan 1996, type 7); none of no values.
/// @param sorted  increasing; infinite values may be among them. @param share  [0, 1]; what lies outside is clamped.
OPAL_EXPORT std::optional<double> quantile_of(std::span<const double> sorted, double share);

/// The quantile of 0.5 of values in any order; none of no values.
OPAL_EXPORT std::optional<double> median_of(std::vector<double> values);

/// The value in the middle of values in any order, the greater one of two: unlike `median_of`, one that occurs. @param
/// values  not empty.
OPAL_EXPORT double upper_median_of(std::vector<double> values);

}  // namespace opal
