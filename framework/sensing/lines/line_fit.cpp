#include <opal/sensing/lines/line_extraction.hpp>

#include <algorithm>

namespace opal {
namespace {

/// Weighted sums of points, from which a total least squares line follows in closed form.
struct Moments {
  double weight = 0;
  Point first = Point::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void add(const Point& p, double w) {
    weight += w;
    first += w * p;
    second += w * p * p.transpose();
  }
  Point centroid() const { return first / weight; }
  Eigen::Matrix2d scatter() const { return second - first * first.transpose() / weight; }
};

/// Direction of largest scatter: tan(2 angle) = 2 S_xy / (S_xx - S_yy).
Point main_direction(const Eigen::Matrix2d& scatter) {
  return unit_vector(0.5 * std::atan2(2 * scatter(0, 1), scatter(0, 0) - scatter(1, 1)));
}

template <class Visit>
void for_each_hit(const ScanChains& chains, std::span<const Run> runs, Visit visit) {
  for (const Run& run : runs)
    for (int i = run.first; i <= run.last; ++i) visit(chains.hits[i]);
}

void set_line(LineFit& fit, const Moments& moments, const Point& along) {
  fit.centroid = moments.centroid();
  fit.direction = main_direction(moments.scatter());
  if (fit.direction.dot(along) < 0) fit.direction = -fit.direction;
}

/// One round of reweighted least squares with Cauchy's loss, so that a chair at the wall does not turn the
/// wall.
Moments reweighted(const ScanChains& chains, std::span<const Run> runs, const LineFit& fit, const ReadingNoise& noise) {
  constexpr double kCauchyScale = 3;  // standard deviations
  const Point normal = left_of(fit.direction);
  Moments moments;
  for_each_hit(chains, runs, [&](const ScanPoint& p) {
    const double variance = variance_across(p, normal, noise);
    const double distance = normal.dot(p.position - fit.centroid);
    const double u2 = distance * distance / (variance * kCauchyScale * kCauchyScale);
    moments.add(p.position, 1 / (variance * (1 + u2)));
  });
  return moments;
}

/// Variances from the weights; grown where the points lie farther off than their noise explains.
void set_uncertainty(LineFit& fit, const Moments& moments, const ScanChains& chains, std::span<const Run> runs) {
  const Point normal = left_of(fit.direction);
  int count = 0;
  double squares = 0;
  for_each_hit(chains, runs, [&](const ScanPoint& p) {
    const double distance = normal.dot(p.position - fit.centroid);
    squares += distance * distance;
    ++count;
  });
  fit.rms_m = std::sqrt(squares / std::max(count, 1));
  const Eigen::Matrix2d scatter = moments.scatter();
  const double across = std::max(normal.dot(scatter * normal), 0.0);
  const double along = std::max(fit.direction.dot(scatter * fit.direction), 1e-12);
  const double growth = count > 2 ? std::max(1.0, across / (count - 2)) : 1.0;
  fit.offset_variance_m2 = growth / moments.weight;
  fit.heading_variance_rad2 = growth / along;
}

}  // namespace

double variance_across(const ScanPoint& hit, const Point& normal, const ReadingNoise& noise) {
  const double cosine = hit.position.dot(normal) / hit.range_m;
  const double along_beam = noise.range_sigma_m * cosine;
  const double across_beam = noise.bearing_sigma_rad * hit.range_m;
  return along_beam * along_beam + across_beam * across_beam * (1 - cosine * cosine) +
         noise.surface_sigma_m * noise.surface_sigma_m;
}

LineFit fit_line(const ScanChains& chains, std::span<const Run> runs, const ReadingNoise& noise) {
  constexpr int kRounds = 2;  // a third changes the line by less than 0.1 standard deviations
  const Point along = chains.hits[runs.back().last].position - chains.hits[runs.front().first].position;
  LineFit fit;
  Moments moments;
  for_each_hit(chains, runs, [&](const ScanPoint& p) { moments.add(p.position, 1); });
  set_line(fit, moments, along);
  for (int round = 0; round < kRounds; ++round) {
    moments = reweighted(chains, runs, fit, noise);
    set_line(fit, moments, along);
  }
  set_uncertainty(fit, moments, chains, runs);
  return fit;
}

}  // namespace opal
