#include "import_kit/plan_material.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace opal {
namespace {

/// Whether a ray along the x axis crosses the ring an odd number of times.
bool crosses_oddly(const std::vector<Point>& ring, const Point& p) {
  bool is_odd = false;
  for (std::size_t k = 0; k < ring.size(); ++k) is_odd ^= is_crossed_by_ray({ring[k], ring[(k + 1) % ring.size()]}, p);
  return is_odd;
}

PlanBoxes::Box box_of(const std::vector<std::vector<Point>>& rings) {
  Eigen::AlignedBox2d box;
  for (const std::vector<Point>& ring : rings)
    for (const Point& p : ring) box.extend(p);
  return PlanBoxes::around(box.min(), box.max(), 0);
}

}  // namespace

bool PlanMaterial::Region::contains(const Point& p) const {
  if (rings.empty()) return (p - disc.center).norm() < disc.radius_m;
  return std::count_if(rings.begin(), rings.end(), [&](const auto& ring) { return crosses_oddly(ring, p); }) % 2 == 1;
}

void PlanMaterial::add(std::vector<std::vector<Point>> rings, Reason reason, int element) {
  std::erase_if(rings, [](const std::vector<Point>& ring) { return ring.size() < 3; });
  if (rings.empty()) return;
  boxes_.push_back(box_of(rings));
  regions_.push_back({std::move(rings), {}, reason, element});
}

void PlanMaterial::add(const Circle& disc, int element) {
  boxes_.push_back(PlanBoxes::around(disc.center, disc.center, disc.radius_m));
  regions_.push_back({{}, disc, outline, element});
}

void PlanMaterial::finish() { index_.emplace(boxes_); }

unsigned PlanMaterial::at(const Point& p, int except_element) const {
  unsigned reasons = none;
  index_->visit(PlanBoxes::around(p, p, 0), [&](int number) {
    const Region& region = regions_[static_cast<std::size_t>(number)];
    const bool is_excepted = except_element >= 0 && region.element == except_element;
    if (!is_excepted && (reasons & region.reason) == 0 && region.contains(p)) reasons |= region.reason;
  });
  return reasons;
}

}  // namespace opal
