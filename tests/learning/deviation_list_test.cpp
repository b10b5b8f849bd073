#include "learning/deviation_list.hpp"
#include "made_drives.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::made;

namespace {

/// The line of an object, without its end.
std::string line_of(const std::string& csv, const std::string& begin) {
  const std::size_t from = csv.find("\n" + begin);
  REQUIRE(from != std::string::npos);
  return csv.substr(from + 1, csv.find('\n', from + 1) - from - 1);
}

std::shared_ptr<const SemanticMap> imported(const std::string& id, const std::string& source_class) {
  MapObject object{id, "opal:Wall"};
  object.notes.name = "Wall \"A\", east";
  object.notes.storey = "Ground";
  object.notes.source_class = source_class;
  object.notes.merged_ids = {"2a", "2b"};
  const MapFeature face{"face", MapObjectNumber(0), "opal:Wall", kSensor, Segment{{0, 0}, {8, 0}}};
  return SemanticMap::make("house", {object}, {face});
}

std::string csv_of(const SemanticMap& map, const std::string& id) {
  return deviation_csv(map,
                       learned_from(map, std::vector{drive("a", {seen(id, kGone)}), drive("b", {seen(id, kGone)})}));
}

}  // namespace

TEST_CASE("what came from IFC has its GlobalId in the list, also in a stack of storeys") {
  const std::string tail = ",0pGAjlJMP3ifYPATVF5xAR,\"Wall \"\"A\"\", east\",Ground,2a 2b";
  for (const std::string id : {"0pGAjlJMP3ifYPATVF5xAR", "Ground/0pGAjlJMP3ifYPATVF5xAR"}) {
    const std::string line = line_of(csv_of(*imported(id, "IfcWall"), id), id + ",opal:Wall,gone,");
    CHECK(line.substr(line.size() - tail.size()) == tail);
  }
}

TEST_CASE("what came from elsewhere, or was added, has no GlobalId in the list") {
  const std::string line = line_of(csv_of(*imported("layer/7", "WALLS"), "layer/7"), "layer/7,");
  CHECK(line.find(",2,,\"Wall") != std::string::npos);
  const auto map = room();
  const std::vector<UnmappedFace> faces{{{{2, 3}, {5, 3}}, 10, 0}};
  const std::string csv = deviation_csv(*map, learned_from(*map, std::vector{drive("a", {}, faces)}));
  CHECK(line_of(csv, "learned-1,").ends_with(",1,,,,"));
}

TEST_CASE("a name that a table would take apart is quoted") {
  const std::string id = "a,\"b\"";
  CHECK(csv_of(*imported(id, ""), id).find("\n\"a,\"\"b\"\"\",opal:Wall,gone,") != std::string::npos);
}
