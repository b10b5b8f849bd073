#pragma once

#include <opal/common/geometry.hpp>

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <utility>
#include <vector>

namespace opal {

/// Numbered boxes, to ask which of them touch another one.
class PlanBoxes {
  using Corner = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
  using Entry = std::pair<boost::geometry::model::box<Corner>, int>;

 public:
  using Box = boost::geometry::model::box<Corner>;

  static Box around(const Point& a, const Point& b, double margin_m) {
    const Point low = a.cwiseMin(b).array() - margin_m, high = a.cwiseMax(b).array() + margin_m;
    return {{low.x(), low.y()}, {high.x(), high.y()}};
  }

  /// @param boxes  number k is entry k.
  explicit PlanBoxes(const std::vector<Box>& boxes) : tree_(numbered(boxes)) {}

  /// Calls visit(number) for each, in no order.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    for (auto found = tree_.qbegin(boost::geometry::index::intersects(box)); found != tree_.qend(); ++found)
      visit(found->second);
  }

 private:
  static std::vector<Entry> numbered(const std::vector<Box>& boxes) {
    std::vector<Entry> entries;
    for (std::size_t k = 0; k < boxes.size(); ++k) entries.emplace_back(boxes[k], static_cast<int>(k));
    return entries;
  }

  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> tree_;
};

}  // namespace opal
