#include "import_kit/plan_nodes.hpp"

#include <cmath>

namespace opal {

int PlanNodes::nearest(const Point& p, const Bucket& middle) const {
  int best = -1;
  double best_m = join_m_;
  for (std::int64_t column = middle.first - 1; column <= middle.first + 1; ++column)
    for (std::int64_t row = middle.second - 1; row <= middle.second + 1; ++row)
      if (const auto found = buckets_.find({column, row}); found != buckets_.end())
        for (const int node : found->second)
          if (const double d = (points_[static_cast<std::size_t>(node)] - p).norm(); d <= best_m) {
            best = node;
            best_m = d;
          }
  return best;
}

int PlanNodes::add(const Point& p) {
  const Bucket bucket{static_cast<std::int64_t>(std::floor(p.x() / join_m_)),
                      static_cast<std::int64_t>(std::floor(p.y() / join_m_))};
  if (const int node = nearest(p, bucket); node >= 0) return node;
  points_.push_back(p);
  buckets_[bucket].push_back(static_cast<int>(points_.size()) - 1);
  return static_cast<int>(points_.size()) - 1;
}

}  // namespace opal
