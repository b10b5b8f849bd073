#pragma once

#include <span>
#include <vector>

namespace opal::statistics {

/// Who looks at an experiment while it runs, and would end it, must ask for more at each look. These are the levels
/// that a two-sided p-value must reach at each, so that the chance of a false claim at any of them is `level`: alpha
/// spending by a function like O'Brien and Fleming's, 2 - 2 Phi(z / sqrt t) on either side (Lan & DeMets 1983), with
/// the joint distribution of all looks by numerical integration (Armitage, McPherson & Rowe 1969).
/// @param information  increasing, in (0, 1]: share of all queries known at each look.
/// @throws opal::Error if it is not.
std::vector<double> look_levels(double level, std::span<const double> information);

/// Of look number `look` (1..looks) of looks that lie equally far apart.
double look_level(double level, int look, int looks);

}  // namespace opal::statistics
