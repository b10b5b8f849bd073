#pragma once

namespace opal::statistics {

/// What a quantity lies in with some confidence; ends may be infinite.
struct Interval {
  double low = 0, high = 0;

  bool contains(double value) const { return low <= value && value <= high; }
};

}  // namespace opal::statistics
