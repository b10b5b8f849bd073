#pragma once

#include "evaluation/calibration.hpp"

#include <limits>
#include <string>
#include <vector>

namespace opal::experiments {

/// A run in which something never happened counts as this: it has a rank, and no value.
constexpr double kNever = std::numeric_limits<double>::infinity();

/// median_of(); `kNever` if there is none.
double median(std::vector<double> values);

/// An interval that holds the median of where the values come from with at least 95 %, whatever their
/// distribution: between two order statistics (Conover 1999, 3.2). All values, which say less, if there are
/// fewer than six.
Interval median_interval(std::vector<double> values);

/// "2.50"; "-" for what is not finite.
std::string number(double value, int decimals);

/// "39 of 40, 97.5 % (95 %: 87.1 to 99.6)", Wilson's interval.
std::string share_text(int part, std::size_t whole);

}  // namespace opal::experiments
