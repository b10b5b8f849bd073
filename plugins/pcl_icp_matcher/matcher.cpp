// The one unit that instantiates PCL templates.
#include "matcher.hpp"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/transformation_estimation_2D.h>

#include <Eigen/LU>

namespace opal::pcl_icp {
namespace {

using PclPoint = pcl::PointXYZ;
using Cloud = pcl::PointCloud<PclPoint>;
using Registration = pcl::IterativeClosestPoint<PclPoint, PclPoint>;

constexpr std::size_t kFewestPoints = 10;
constexpr double kFarthest_m = 1e4;  ///< PCL works in single precision

/// Finite points relative to `origin`, at most about `most` of them, evenly by index.
Cloud::Ptr cloud_of(std::span<const Point> points, const Point& origin, std::size_t most) {
  auto cloud = std::make_shared<Cloud>();
  const std::size_t stride = std::max<std::size_t>(1, points.size() / most);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Point p = points[i] - origin;
    if (p.allFinite() && p.cwiseAbs().maxCoeff() < kFarthest_m)
      cloud->push_back(PclPoint(static_cast<float>(p.x()), static_cast<float>(p.y()), 0));
  }
  return cloud;
}

Eigen::Matrix4f matrix_of(const Pose2& pose) {
  Eigen::Matrix4f m = Eigen::Matrix4f::Identity();
  const auto c = static_cast<float>(std::cos(pose.heading_rad())), s = static_cast<float>(std::sin(pose.heading_rad()));
  m.topLeftCorner<2, 2>() << c, -s, s, c;
  m.block<2, 1>(0, 3) = pose.position().cast<float>();
  return m;
}

Pose2 pose_of(const Eigen::Matrix4f& m) {
  return {Point(m.block<2, 1>(0, 3).cast<double>()),
          std::atan2(static_cast<double>(m(1, 0)), static_cast<double>(m(0, 0)))};
}

/// Points of the scan, moved to `pose`, that lie within `distance_m` of the reference.
std::vector<Point> near_reference(Registration& icp, const Cloud& scan, const Pose2& pose, double distance_m) {
  std::vector<Point> near;
  pcl::Indices index(1);
  std::vector<float> squared(1);
  for (const PclPoint& p : scan) {
    const Point moved = pose * Point(p.x, p.y);
    const PclPoint query(static_cast<float>(moved.x()), static_cast<float>(moved.y()), 0);
    if (icp.getSearchMethodTarget()->nearestKSearch(query, 1, index, squared) > 0 &&
        static_cast<double>(squared[0]) <= distance_m * distance_m)
      near.push_back(moved);
  }
  return near;
}

/// Least squares of point pairs, with the guess as prior. It knows nothing of corridors: a point pair holds in both
/// directions.
Eigen::Matrix3d covariance_of(const std::vector<Point>& pairs, const Pose2& pose, double point_sigma_m,
                              const Eigen::Vector3d& guess_sigma) {
  Eigen::Matrix3d information = guess_sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  for (const Point& p : pairs) {
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << Eigen::Matrix2d::Identity(), left_of(p - pose.position());
    information += jacobian.transpose() * jacobian / (point_sigma_m * point_sigma_m);
  }
  return information.inverse();
}

void configure(Registration& icp, const MatcherOptions& options) {
  icp.setTransformationEstimation(
      std::make_shared<pcl::registration::TransformationEstimation2D<PclPoint, PclPoint>>());
  icp.setMaxCorrespondenceDistance(options.correspondence_m);
  icp.setMaximumIterations(options.iterations);
  icp.setTransformationEpsilon(1e-8);
}

}  // namespace

ScanMatch PclIcpMatcher::match(std::span<const Point> reference, std::span<const Point> scan, const Pose2& guess,
                               const Eigen::Vector3d& guess_sigma) const {
  const Eigen::Vector3d sigma = guess_sigma.cwiseMax(1e-4);
  ScanMatch result;
  result.T_reference_scan = guess;
  result.covariance = sigma.cwiseAbs2().asDiagonal();
  if (reference.empty() || !sigma.allFinite()) return result;
  const Point& origin = guess.position();  // single precision: keep numbers small
  const Cloud::Ptr target = cloud_of(reference, origin, reference.size());
  const Cloud::Ptr source = cloud_of(scan, Point::Zero(), static_cast<std::size_t>(options_.max_points));
  if (target->size() < kFewestPoints || source->size() < kFewestPoints) return result;

  Registration icp;
  configure(icp, options_);
  icp.setInputTarget(target);
  icp.setInputSource(source);
  const Pose2 start(Point::Zero(), guess.heading_rad());
  icp.getSearchMethodTarget()->setInputCloud(target);
  if (near_reference(icp, *source, start, options_.correspondence_m).size() < kFewestPoints) return result;
  Cloud aligned;
  icp.align(aligned, matrix_of(start));
  const Pose2 pose = pose_of(icp.getFinalTransformation());
  if (!icp.hasConverged() || !pose.position().allFinite()) return result;
  const std::vector<Point> pairs = near_reference(icp, *source, pose, options_.inlier_distance_m);
  result.T_reference_scan = Pose2(origin + pose.position(), pose.heading_rad());
  result.covariance = covariance_of(pairs, pose, options_.point_sigma_m, sigma);
  result.inlier_share = static_cast<double>(pairs.size()) / static_cast<double>(source->size());
  result.converged = result.inlier_share >= options_.min_inlier_share;
  return result;
}

}  // namespace opal::pcl_icp
