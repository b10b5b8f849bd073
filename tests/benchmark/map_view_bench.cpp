// What it costs to look at a map of growing size, mostly: which faces of it are one line. Rooms of 4 m with doorways and
// walls 0.2 m thick, faces moved by up to 3 cm, as a drawing lies (0 rad) and turned by 0.5 rad.
#include <opal/map_view.hpp>

#include <catch2/catch.hpp>

#include <cstdio>
#include <ctime>
#include <random>

using namespace opal;

namespace {

double now_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }  // CPU time: the machine may be busy

/// The two sides of a wall between `a` and `b`, 0.2 m thick.
void add_wall(std::vector<Segment>& faces, const Point& a, const Point& b) {
  const Point half = 0.1 * Segment{a, b}.normal();
  faces.push_back({a + half, b + half});
  faces.push_back({b - half, a - half});
}

std::vector<Segment> rooms(int count, double turned_rad) {
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
  for (Segment& face : faces) {
    const Point moved = aside(random) * face.normal();
    face = transformed(Pose2(Point::Zero(), turned_rad), Segment{face.begin + moved, face.end + moved});
  }
  return faces;
}

std::shared_ptr<const SemanticMap> map_of(const std::vector<Segment>& faces) {
  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  for (const Segment& face : faces) {
    const int number = static_cast<int>(features.size());
    objects.push_back({"wall-" + std::to_string(number), "opal:Wall", {number}});
    MapFeature& feature = features.emplace_back();
    feature.id = "face-" + std::to_string(number);
    feature.object = number;
    feature.type = "opal:Wall";
    feature.sensor = "PlanarLidar2D";
    feature.geometry = face;
  }
  return SemanticMap::make("rooms", objects, features);
}

}  // namespace

TEST_CASE("a view of maps of growing size", "[!benchmark]") {
  std::printf("\n  faces  turned rad  view s  lines\n");
  for (const double turned_rad : {0.0, 0.5})
    for (const int size : {1000, 10000, 30000}) {
      const auto map = map_of(rooms(size, turned_rad));
      const double start_s = now_s();
      const MapView view(map, "PlanarLidar2D");
      const double taken_s = now_s() - start_s;
      int lines = 0;
      for (int number : view.features()) lines += view.surface(number).line == number;
      CHECK(lines > 0);
      std::printf("%7zu  %10.1f  %6.3f  %5d\n", map->features().size(), turned_rad, taken_s, lines);
    }
}
