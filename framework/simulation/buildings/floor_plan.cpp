#include "simulation/buildings/floor_plan.hpp"

namespace opal::simulation {

void FloorPlan::thing(const Box& box, const std::string& type) {
  strokes_.push_back({box, Ground::solid, static_cast<int>(things_.size()), kNoSpace});
  things_.push_back(type);
}

void FloorPlan::close(const Box& opening, int thickness, const std::string& type) {
  open(opening);
  Box body = opening;
  if (opening.width() > opening.height()) {
    body.bottom = (opening.bottom + opening.top - thickness) / 2;
    body.top = body.bottom + thickness;
  } else {
    body.left = (opening.left + opening.right - thickness) / 2;
    body.right = body.left + thickness;
  }
  closures_.push_back({body, type});
}

}  // namespace opal::simulation
