#pragma once

#include <opal/common/geometry.hpp>

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace opal {

/// Points of which no two are nearer to each other than a distance: who comes later is the one that is there already.
class PlanNodes {
 public:
  explicit PlanNodes(double join_m) : join_m_(join_m) {}

  int add(const Point& p);
  const std::vector<Point>& points() const { return points_; }

 private:
  using Bucket = std::pair<std::int64_t, std::int64_t>;
  struct Hash {
    std::size_t operator()(const Bucket& bucket) const {
      return static_cast<std::size_t>(bucket.first) * 0x9E3779B97F4A7C15ULL ^ static_cast<std::size_t>(bucket.second);
    }
  };
  int nearest(const Point& p, const Bucket& middle) const;

  double join_m_;
  std::vector<Point> points_;
  std::unordered_map<Bucket, std::vector<int>, Hash> buckets_;
};

}  // namespace opal
