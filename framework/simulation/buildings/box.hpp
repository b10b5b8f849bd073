#pragma once

namespace opal::simulation {

/// A rectangle of a floor plan, sides along the axes of frame `map`, whole centimetres: plans have no rounding.
struct Box {
  int left = 0, bottom = 0, right = 0, top = 0;

  int width() const { return right - left; }
  int height() const { return top - bottom; }
};

}  // namespace opal::simulation
