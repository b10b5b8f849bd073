#include "simulation/ray_caster.hpp"
#include "common/random.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::simulation;

namespace {

std::vector<Solid> scattered(Random& random, int count) {
  std::vector<Solid> solids;
  const auto somewhere = [&] { return Point{random.uniform(-30, 20), random.uniform(-10, 40)}; };
  for (int k = 0; k < count; ++k) {
    const Point at = somewhere();
    if (random.chance(0.3))
      solids.push_back({Circle{at, random.uniform(0.01, 2.5)}, false});
    else
      solids.push_back(
          {Segment{at, random.chance(0.1) ? somewhere() : Point(at + Point{random.normal(3), random.normal(3)})},
           false});
  }
  return solids;
}

/// Range to one solid, computed without a grid and by another formula.
double range_to(const Solid& solid, const Point& origin, const Point& direction) {
  const double never = std::numeric_limits<double>::infinity();
  if (const auto* circle = std::get_if<Circle>(&solid.shape)) {
    const Point to = circle->center - origin;
    const double b = -2 * direction.dot(to), c = to.squaredNorm() - circle->radius_m * circle->radius_m;
    const double root = b * b - 4 * c;
    if (root < 0) return never;
    for (const double range : {(-b - std::sqrt(root)) / 2, (-b + std::sqrt(root)) / 2})
      if (range > 0) return range;
    return never;
  }
  const auto& segment = std::get<Segment>(solid.shape);
  Eigen::Matrix2d system;
  system << direction, segment.begin - segment.end;
  if (system.determinant() == 0) return never;
  const Eigen::Vector2d at = system.partialPivLu().solve(segment.begin - origin);
  return at.x() > 0 && at.y() >= 0 && at.y() <= 1 ? at.x() : never;
}

}  // namespace

TEST_CASE("the grid's answer is that of a look at every solid") {
  Random random(GENERATE(1, 2, 3, 4));
  const RayCaster caster(scattered(random, 80));
  for (int k = 0; k < 3000; ++k) {
    const Point origin{random.uniform(-40, 30), random.uniform(-20, 50)};
    const Point direction = unit_vector(random.chance(0.1) ? std::numbers::pi / 2 * std::floor(random.uniform(0, 4))
                                                           : random.uniform(-4, 4));
    const double reach = random.uniform(0.5, 60);
    double nearest = reach;
    for (const Solid& solid : caster.solids()) nearest = std::min(nearest, range_to(solid, origin, direction));
    const RayHit hit = caster.cast(origin, direction, reach);
    INFO("from (" << origin.x() << ", " << origin.y() << ") along (" << direction.x() << ", " << direction.y()
                  << "), reach " << reach);
    if (nearest < reach)
      CHECK(hit.range_m == Approx(nearest).margin(1e-7));
    else
      CHECK(hit.solid == -1);
  }
}

TEST_CASE("what cannot be met, is not") {
  const double nan = std::nan("");
  const RayCaster caster({{Segment{{nan, 0}, {1, 1}}, false}, {Point(1, 0), false}, {Circle{{5, 0}, 1}, false}});
  CHECK(caster.solids().size() == 1);
  CHECK(caster.cast({0, 0}, {1, 0}, 10).range_m == Approx(4));
  CHECK(caster.cast({0, 0}, {nan, 0}, 10).solid == -1);
  CHECK(caster.cast({nan, 0}, {1, 0}, 10).solid == -1);
  CHECK(RayCaster({}).cast({0, 0}, {1, 0}, 10).solid == -1);
}

TEST_CASE("a disc touches what is nearer than its radius, and what it is inside of") {
  const RayCaster caster({{Segment{{0, 0}, {10, 0}}, false}, {Circle{{5, 5}, 2}, false}});
  CHECK(caster.touches({3, 0.2}, 0.3));
  CHECK_FALSE(caster.touches({3, 0.4}, 0.3));
  CHECK(caster.touches({5, 5}, 0.3));
  CHECK_FALSE(caster.touches({5, 2.5}, 0.3));
  CHECK_FALSE(caster.touches({-100, 500}, 0.3));
}
