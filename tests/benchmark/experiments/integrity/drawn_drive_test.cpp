#include "benchmark/experiments/integrity/campaign.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <map>

using namespace opal;
using namespace opal::experiments;
using Catch::Contains;

namespace {

Campaign campaign_of(std::size_t drives, std::uint64_t seed = 1) {
  CampaignRequest request;
  request.drives = drives;
  request.seed = seed;
  return Campaign(request);
}

}  // namespace

TEST_CASE("a drive is the same however many there are, and another one with another seed") {
  const Campaign few = campaign_of(10), many = campaign_of(10000), other = campaign_of(10, 2);
  int same = 0;
  for (std::size_t number = 0; number < few.size(); ++number) {
    CHECK(to_json(few.drive(number)) == to_json(many.drive(number)));
    same += to_json(few.drive(number)) == to_json(other.drive(number));
  }
  CHECK(same == 0);
}

TEST_CASE("all that a campaign is to try is in it, in parts of some size") {
  const Campaign campaign = campaign_of(10000);
  std::map<std::string, int> count;
  for (std::size_t number = 0; number < campaign.size(); ++number) {
    const DrawnDrive drive = campaign.drive(number);
    ++count[drive.building.kind];
    ++count[std::string("map ") + name_of(drive.map_state)];
    ++count["event " + event_of(drive)];
    ++count[drive.has_two_lasers ? "two lasers" : "one laser"];
    count["furnished"] += drive.along_walls > 0;
    count["storeys"] += drive.storeys > 1;
    CHECK(drive.storey < drive.storeys);
    CHECK_FALSE((drive.is_kidnapped && drive.fault != simulation::Fault::none));
  }
  for (const MapState state : kMapStates) CHECK(count[std::string("map ") + name_of(state)] > 500);
  for (const simulation::Fault fault : simulation::kFaults) CHECK(count[std::string("event ") + name_of(fault)] > 300);
  for (const char* name : {"office", "hall", "warehouse", "corridor", "event kidnapped", "event none", "one laser",
                           "two lasers", "furnished", "storeys"}) {
    INFO(name);
    CHECK(count[name] > 1000);
  }
}

TEST_CASE("a drive's document gives the drive again") {
  const Campaign campaign = campaign_of(200);
  for (std::size_t number = 0; number < campaign.size(); ++number) {
    const nlohmann::ordered_json document = to_json(campaign.drive(number));
    const auto read = nlohmann::json::parse(document.dump());
    CHECK(to_json(drawn_drive_from(read, "drive.json")) == document);
  }
}

TEST_CASE("a document that is no drive is refused with file, place, what was found and what was expected") {
  const auto refused = [](const char* pointer, const nlohmann::json& value) {
    nlohmann::json document = nlohmann::json::parse(to_json(campaign_of(1).drive(0)).dump());
    document[nlohmann::json::json_pointer(pointer)] = value;
    return refused_with<ConfigError>([&] { drawn_drive_from(document, "drive.json"); });
  };
  CHECK(refused("/event", "flood") ==
        "drive.json: /event: \"flood\", expected one of \"dropped\", \"doubled\", \"reordered\", \"late\", \"clock "
        "back\", \"laser gone\", \"odometry frozen\", \"wheels slip\"");
  CHECK_THAT(refused("/map", "golden"), Contains("drive.json: /map: \"golden\", expected one of \"sound\""));
  CHECK(refused("/storey", 7) == "drive.json: /storey: 7, expected 0 to 0");
  CHECK(refused("/people", -1) == "drive.json: /people: -1, expected 0 to 1000");
  CHECK(refused("/damage", 1.5) == "drive.json: /damage: 1.5, expected 0.0 to 1.0");
  CHECK_THAT(refused("/duration_s", "long"), Contains("drive.json: is no drive of a campaign"));
  CHECK_THAT(refused("/building", nullptr), Contains("drive.json: is no drive of a campaign"));
}
