// Grids that SLAM programs made of real buildings; skipped where these are not at hand. Bounds are a little outside of
// what plugins/grid_importer/README.md reports.
#include "drawn_grid.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

namespace {

using namespace opal;
using namespace opal::test;

struct Expected {
  const char* site;
  int long_faces;   ///< of at least 1 m, at least
  double length_m;  ///< in all, at least
  int columns;      ///< round ones, at least
};

}  // namespace

TEST_CASE("walls of recorded buildings come out as long faces") {
  const Expected expected =
      GENERATE(Expected{"acapulco", 230, 800, 1}, Expected{"belgioioso", 150, 550, 0}, Expected{"csail", 155, 600, 1},
               Expected{"freiburg-079", 95, 370, 1}, Expected{"malaga-demo", 38, 150, 2},
               Expected{"malaga", 40, 195, 17}, Expected{"seattle", 55, 190, 0});
  const std::string path = std::string(OPAL_SOURCE_DIR "/../shared/data/sites/") + expected.site + ".map.yaml";
  if (!std::filesystem::exists(path)) {
    WARN(path << " is not here: skipped");
    return;
  }
  const auto map = grid_importer()->import(path).map;
  CAPTURE(expected.site);
  int long_faces = 0;
  double length_m = 0;
  for (const Segment& face : all<Segment>(*map)) {
    long_faces += face.length_m() >= 1;
    length_m += face.length_m();
  }
  CHECK(long_faces >= expected.long_faces);
  CHECK(length_m >= expected.length_m);
  CHECK(static_cast<int>(all<Circle>(*map).size()) >= expected.columns);
}
