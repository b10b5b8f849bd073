#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include "drawing/drawing.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <limits>

using namespace opal;

namespace {

std::string picture_path(const std::string& name) {
  static const TemporaryFolder kFolder;
  return kFolder.path_of(name);
}

/// Width and height [px] that a PNG states (PNG specification, 11.2.2).
std::array<int, 2> png_size(const std::string& bytes) {
  const auto number = [&](int at) {
    int value = 0;
    for (int k = 0; k < 4; ++k) value = value * 256 + static_cast<unsigned char>(bytes.at(at + k));
    return value;
  };
  return {number(16), number(20)};
}

DrawingScene hall() {
  std::vector<MapObject> objects{{"south", "opal:Wall", {MapFeatureNumber(0)}},
                                 {"column", "opal:Column", {MapFeatureNumber(1)}},
                                 {"lift", "acme:Lift", {MapFeatureNumber(2)}}};
  std::vector<MapFeature> features(3);
  features[0] = {"south/face", MapObjectNumber(0), "opal:Wall", "PlanarLidar2D", Segment{{0, 0}, {20, 0}}, 0, 1, {}};
  features[1] = {"column/rim", MapObjectNumber(1), "opal:Column", "PlanarLidar2D", Circle{{5, 4}, 0.3}, 0, 1, {}};
  features[2] = {
      "lift/corner", MapObjectNumber(2), "opal:Corner", "PlanarLidar2D", OrientedPoint{{9, 8}, 0.3, 1.5}, 0, 1, {}};
  DrawingScene scene;
  scene.title = "hall";
  scene.map = SemanticMap::make("hall", objects, features);
  scene.hypotheses = {{Pose2(4, 2, 0.5), 0.8}, {Pose2(14, 2, 2.5), 0.15}};
  scene.scan_points = {{1, 0.02}, {2, -0.01}, {4.8, 3.8}};
  scene.free_space = {{4, 2}, {1, 0}, {2, 0}, {4.8, 3.8}};
  scene.associations = {{Segment{{1, 0.02}, {2, -0.01}}, Segment{{0, 0}, {20, 0}}}};
  scene.trajectory = {{3, 1}, {3.5, 1.5}, {4, 2}};
  scene.truth = {{3, 1.1}, {3.5, 1.4}, {4, 2.1}};
  scene.local_features = {{Segment{{1, 0.02}, {2, -0.01}}, DrawingScene::Perception::matched},
                          {Point(7, 1), DrawingScene::Perception::candidate},
                          {Circle{{5.02, 4.01}, 0.29}, DrawingScene::Perception::stable}};
  scene.patterns = {{{1.5, 0}, {5, 4}}};
  scene.ended = {Pose2(10, 6, 1)};
  scene.contradictions = {{Point(4, 2), Point(9, 8)}};
  scene.notes = {"a note", "a note of so many words that it needs more than one line to be read beside the picture"};
  return scene;
}

}  // namespace

TEST_CASE("a scene becomes an SVG and a PNG of the same shape") {
  const std::string svg = picture_path("hall.svg"), png = picture_path("hall.png");
  write_svg(hall(), svg);
  write_png(hall(), png);
  const std::string text = content_of(svg);
  CHECK(text.find("<svg") != std::string::npos);
  CHECK(text.find("</svg>") != std::string::npos);
  double width = 0, height = 0;
  REQUIRE(std::sscanf(text.c_str() + text.find("width=\""), "width=\"%lf%*[a-z]\" height=\"%lf", &width, &height) == 2);
  const auto [png_width, png_height] = png_size(content_of(png));
  CHECK(png_width / width == Approx(png_height / height).epsilon(0.01));
}

TEST_CASE("the same scene is the same picture, byte for byte") {
  const std::string once = picture_path("once.png"), again = picture_path("again.png");
  write_png(hall(), once);
  write_png(hall(), again);
  CHECK(content_of(once) == content_of(again));
}

TEST_CASE("places, storeys and coordinates are drawn") {
  const std::string plain = picture_path("plain.png"), more = picture_path("more.png");
  write_png(hall(), plain);
  const auto is_other = [&](const auto& change) {
    DrawingScene scene = hall();
    change(scene);
    write_png(scene, more);
    return content_of(more) != content_of(plain);
  };
  CHECK(is_other([](DrawingScene& scene) { scene.places = {{Point(12, 5), "goal"}}; }));
  CHECK(is_other([](DrawingScene& scene) { scene.coordinates = true; }));
  CHECK(is_other([](DrawingScene& scene) {
    MapOrigin origin;
    origin.storeys = {{"hall"}};
    std::vector<MapFeature> features = scene.map->features();
    for (MapFeature& feature : features) feature.id = "hall/" + feature.id;
    std::vector<MapObject> objects = scene.map->objects();
    scene.map = SemanticMap::make("hall", objects, features, {}, origin);
  }));
}

TEST_CASE("the legend calls what is drawn by the words of the picture") {
  const auto drawn = [](const char* words) {
    DrawingScene scene = hall();
    scene.contradictions = {{Point(0, 0), Point(1, 0)}};
    if (words) scene.contradiction_words = words;
    const std::string file = picture_path("words.svg");
    write_svg(scene, file);
    return content_of(file);
  };
  CHECK(drawn(nullptr) == drawn("speaks against it"));
  CHECK(drawn(nullptr) != drawn("gone: beams pass through it"));
}

TEST_CASE("no line is drawn where the estimate jumps") {
  const auto paths = [](const std::vector<Point>& trajectory) {
    DrawingScene scene;
    scene.trajectory = trajectory;
    const std::string file = picture_path("jump.svg");
    write_svg(scene, file);
    const std::string text = content_of(file);
    std::size_t count = 0;
    for (std::size_t at = text.find("<path"); at != std::string::npos; at = text.find("<path", at + 1)) ++count;
    return count;
  };
  // The extents are the same, and so is all that is drawn besides.
  CHECK(paths({{0, 0}, {1, 0}, {11, 0}, {12, 0}}) ==
        paths({{0, 0}, {1.5, 0}, {3, 0}, {4.5, 0}, {6, 0}, {7.5, 0}, {9, 0}, {10.5, 0}, {12, 0}}) + 1);
}

TEST_CASE("an empty scene and one full of nonsense can be drawn") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  DrawingScene nonsense = hall();
  nonsense.title = "\xff\xfe no text";
  nonsense.scan_points = {{nan, 0}, {1e300, 0}, {infinity, -infinity}};
  nonsense.trajectory = {{nan, nan}, {1, 1}, {1e12, 0}};
  nonsense.free_space = {{nan, 0}};
  nonsense.hypotheses = {{Pose2(nan, 0, 0), nan}, {Pose2(1, 1, nan), -5}};
  nonsense.local_features = {{Circle{{0, 0}, nan}}, {Segment{{1, 1}, {1, 1}}}};
  nonsense.ended = {Pose2(nan, 0, nan)};
  nonsense.patterns = {{}, {{nan, nan}, {1, 1}}};
  nonsense.contradictions = {{Point(nan, 0), Point(1e300, infinity)}};
  nonsense.places = {{Point(nan, 0), "\xff"}, {Point(1e300, 0), ""}};
  nonsense.notes = {"", std::string(5000, 'x'), std::string(3000, ' ') + "\xff \n\t"};
  nonsense.view = {Point(3, 3), Point(1, 1)};
  for (const DrawingScene& scene : {DrawingScene{}, nonsense}) {
    const std::string svg = picture_path("odd.svg"), png = picture_path("odd.png");
    CHECK_NOTHROW(write_svg(scene, svg));
    CHECK_NOTHROW(write_png(scene, png));
    CHECK(std::filesystem::file_size(png) > 100);
  }
}

TEST_CASE("a title with bytes that are no UTF-8 does not blank the picture") {
  DrawingScene odd = hall();
  odd.title = "h\xffll";
  const std::string path = picture_path("title.svg"), usual = picture_path("hall.svg");
  write_svg(odd, path);
  write_svg(hall(), usual);
  CHECK(std::filesystem::file_size(path) > 0.8 * static_cast<double>(std::filesystem::file_size(usual)));
}

TEST_CASE("a picture that cannot be written is an error that names the file") {
  const std::string path = "/nonexistent-folder/picture.png";
  CHECK_THROWS_WITH(write_png(hall(), path), Catch::StartsWith(path));
  CHECK_THROWS_WITH(write_svg(hall(), "/nonexistent-folder/picture.svg"), Catch::StartsWith("/nonexistent-folder"));
}
