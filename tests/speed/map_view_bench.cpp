// What it costs to look at a map of growing size, mostly: which faces of it are one line. Rooms of 4 m with doorways
// and walls 0.2 m thick, faces moved by up to 3 cm, as a drawing lies (0 rad) and turned by 0.5 rad.
#include "common/stage_clock.hpp"
#include "tests/patterns/columns.hpp"

#include <catch2/catch.hpp>

#include <cstdio>
#include <random>

using namespace opal;

namespace {

/// The two sides of a wall between `a` and `b`, 0.2 m thick.
void add_wall(std::vector<Segment>& faces, const Point& a, const Point& b) {
  const Point half = 0.1 * Segment{a, b}.normal();
  faces.push_back({a + half, b + half});
  faces.push_back({b - half, a - half});
}

std::vector<Feature> rooms(int count, double turned_rad) {
  std::vector<Segment> faces;
  const int side = static_cast<int>(std::ceil(std::sqrt(count / 8.0)));
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const Point low(4 * i, 4 * j);
      add_wall(faces, low + Point(0.3, 0), low + Point(1.5, 0));
      add_wall(faces, low + Point(2.5, 0), low + Point(3.7, 0));
      add_wall(faces, low + Point(0, 0.3), low + Point(0, 1.5));
      add_wall(faces, low + Point(0, 2.5), low + Point(0, 3.7));
    }
  std::mt19937 random(3);
  std::uniform_real_distribution<double> aside(-0.03, 0.03);
  std::vector<Feature> features;
  for (const Segment& face : faces) {
    const Point moved = aside(random) * face.normal();
    const Segment seen{face.begin + moved, face.end + moved};
    features.push_back({"opal:Wall", transformed(Pose2(Point::Zero(), turned_rad), seen)});
  }
  return features;
}

}  // namespace

TEST_CASE("a view of maps of growing size", "[!benchmark]") {
  std::printf("\n  faces  turned rad  view s  lines\n");
  for (const double turned_rad : {0.0, 0.5})
    for (const int size : {1000, 10000, 30000}) {
      const auto map = map_of(rooms(size, turned_rad));
      const double start_s = thread_cpu_s();
      const MapView view = view_of(map);
      const double taken_s = thread_cpu_s() - start_s;
      int lines = 0;
      for (MapFeatureNumber number : view.features()) lines += view.surface(number).line.number() == number.number();
      CHECK(lines > 0);
      std::printf("%7zu  %10.1f  %6.3f  %5d\n", map->features().size(), turned_rad, taken_s, lines);
    }
}
