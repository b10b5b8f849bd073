#include "localization/decision/map_doubt.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal {
namespace {

// Maps and plans of the building itself let fewer beams pass, once a place was searched for so long.
constexpr double kMostPassing = 0.3;

}  // namespace

void MapDoubt::add(double agreeing, double weight, bool is_localized) {
  agreeing_ = agreeing;
  found_ = is_localized ? found_ + weight : 0;
  unfound_ = is_localized ? 0 : unfound_ + weight;
  if (unfound_ >= most_weight_ && 1 - agreeing_ > kMostPassing) stands_ = true;
  if (found_ >= most_weight_) stands_ = false;
  searched_ = stands_ ? std::max(searched_, unfound_) : 0;
}

void MapDoubt::clear() { *this = MapDoubt(most_weight_); }

std::string MapDoubt::words() const {
  if (!stands_) return "";
  return fmt::format(
      "the map does not explain what the robot sees: no place held for {:.0f} pieces of evidence, and {:.0f} % of the "
      "beams that the map speaks about pass through what it has; is it the map of this building, and of this storey?",
      searched_, 100 * (1 - agreeing_));
}

}  // namespace opal
