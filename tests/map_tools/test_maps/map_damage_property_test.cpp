#include <opal/common/error.hpp>
#include <opal/plugin/testing/scorer_contract.hpp>
#include "map_tools/test_maps/map_damage.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

int segments_in(const SemanticMap& map) {
  return static_cast<int>(std::ranges::count_if(
      map.features(), [](const MapFeature& f) { return std::holds_alternative<Segment>(f.geometry); }));
}

std::shared_ptr<const SemanticMap> worse(const std::string& text, std::uint64_t seed = 1) {
  MapDamage damage = read_map_damage(text);
  damage.seed = seed;
  return damaged_map(*testing::example_map(), damage);
}

}  // namespace

TEST_CASE("no damage changes nothing") { CHECK(worse("")->to_json_ld() == testing::example_map()->to_json_ld()); }

TEST_CASE("the same seed gives the same damage, another seed another") {
  const std::string mixed = "drop=0.3,shift=0.1,wall=0.6,false=0.3";
  CHECK(worse(mixed, 7)->to_json_ld() == worse(mixed, 7)->to_json_ld());
  CHECK(worse(mixed, 7)->to_json_ld() != worse(mixed, 8)->to_json_ld());
}

TEST_CASE("a plan holds long faces only, and everything that is not a face") {
  const auto map = worse("plan=3");
  int others = 0;
  for (const MapFeature& feature : map->features())
    if (const auto* face = std::get_if<Segment>(&feature.geometry))
      CHECK(face->length_m() >= 3);
    else
      ++others;
  CHECK(others == 4);
}

TEST_CASE("dropped and false segments have about the share that was asked for") {
  const int all = segments_in(*testing::example_map());
  int dropped = 0, added = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    dropped += all - segments_in(*worse("drop=0.3", seed));
    added += segments_in(*worse("false=0.5", seed)) - all;
  }
  CHECK(dropped / 50.0 == Approx(0.3 * all).epsilon(0.2));
  CHECK(added / 50.0 == Approx(0.5 * all).epsilon(0.1));
}

TEST_CASE("shifted faces stay parallel to where they were, unless they share points") {
  const auto before = testing::example_map(), after = worse("shift=0.1", 3);
  REQUIRE(before->features().size() == after->features().size());
  double sum = 0;
  int faces = 0;
  for (std::size_t k = 0; k < before->features().size(); ++k) {
    const auto* a = std::get_if<Segment>(&before->features()[k].geometry);
    const auto* b = std::get_if<Segment>(&after->features()[k].geometry);
    if (!a || !b) continue;
    CHECK(std::abs(cross(a->direction(), b->direction())) < 1e-9);
    sum += std::pow(a->normal().dot(b->begin - a->begin), 2);
    ++faces;
  }
  CHECK(std::sqrt(sum / faces) == Approx(0.1).epsilon(0.6));
}

TEST_CASE("words about damage that cannot be read are named") {
  CHECK_THROWS_WITH(read_map_damage("drop=0.3,shft=0.1"), Catch::Contains("'shft=0.1'"));
  CHECK_THROWS_WITH(read_map_damage("drop=x"), Catch::Contains("drop: 'x'"));
  CHECK_THROWS_WITH(read_map_damage("drop=1.5"), Catch::Contains("expected a number from 0 to 1"));
  CHECK_THROWS_AS(read_map_damage("drop"), ConfigError);
}

TEST_CASE("thick walls are read, and are no business of a map that is there already") {
  CHECK(read_map_damage("thick=0.4").thick_m == 0.4);
  CHECK_THROWS_WITH(read_map_damage("thick=3"), Catch::Contains("thick: '3', expected a number from 0 to 2"));
  CHECK(worse("thick=0.4")->to_json_ld() == testing::example_map()->to_json_ld());
}
