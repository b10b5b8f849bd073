#include <opal/local_map/local_map.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("the factor graph takes its turn after so many keyframes, and only then") {
  LocalMapOptions options;
  options.optimize_every = 4;
  LocalMap map(options, nullptr);
  const Eigen::Matrix3d covariance = 4e-4 * Eigen::Matrix3d::Identity();
  const std::vector<Feature> columns{{"opal:Column", Circle{{3, 1}, 0.2}, covariance},
                                     {"opal:Column", Circle{{3, -2}, 0.2}, covariance},
                                     {"opal:Column", Circle{{6, 0}, 0.3}, covariance}};
  std::vector<int> turns;
  for (int k = 0; k < 13; ++k) {
    const Pose2 T_odom_base(0.31 * k, 0.01 * k, 0.01 * k), by_odometry = map.T_local_base_at(T_odom_base);
    std::vector<Feature> detected;
    for (const Feature& column : columns) detected.push_back(transformed(Pose2(0.3 * k, 0, 0).inverse(), column));
    map.add(sample_of({}, T_odom_base), detected);
    if (distance_m(by_odometry, map.T_local_base()) > 1e-6) turns.push_back(k + 1);
  }
  CHECK(turns == std::vector{4, 8, 12});
}
