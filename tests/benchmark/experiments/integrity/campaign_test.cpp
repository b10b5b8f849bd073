#include "tests/kit/file_content.hpp"
#include "tests/kit/shipped_plugins.hpp"
#include "tests/kit/temporary_folder.hpp"

#include "benchmark/experiments/integrity/campaign_work.hpp"
#include "benchmark/experiments/integrity/integrity_page.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <filesystem>

using namespace opal;
using namespace opal::experiments;
using Catch::Contains;

namespace {

const CampaignRobots& robots() {
  static const CampaignRobots robots{with_lasers(read_deployment(OPAL_SOURCE_DIR "/configs/default.jsonld"),
                                                 {simulation::SimulationOptions::default_laser()}),
                                     read_deployment(OPAL_SOURCE_DIR "/configs/two_lasers.jsonld"), &shipped_plugins()};
  return robots;
}

Campaign short_campaign(std::size_t drives) {
  CampaignRequest request;
  request.drives = drives;
  request.duration_s = 12;
  return Campaign(request);
}

/// A small office that is like no other, and a robot that sees well.
DrawnDrive plain_drive() {
  DrawnDrive drive;
  drive.building_id = "office";
  drive.building = {"office", 3, 300, 0};
  drive.clutter = 0.2;
  drive.has_two_lasers = true;
  drive.seed = 5;
  drive.duration_s = 25;
  return drive;
}

IntegrityRun driven(const DrawnDrive& drive, const std::string& scratch) {
  return run_drive(drive, world_of(drive, robots(), scratch), robots());
}

std::vector<std::map<std::string, double>> values_in(const Campaign& campaign, const ab::ResultFolder& folder) {
  std::vector<std::map<std::string, double>> values;
  for (const JudgedDrive& drive : judged_drives(campaign, folder)) {
    INFO(drive.failure);
    CHECK(drive.failure.empty());
    values.push_back(values_of(drive.run));
  }
  return values;
}

void drive_all(const Campaign& campaign, const ab::ResultFolder& folder, const ab::Shard& shard, int jobs) {
  drive_campaign(campaign, robots(), folder, shard, jobs, [](std::size_t, std::size_t) {}, {});
}

}  // namespace

TEST_CASE("a plain drive is localized rightly, the same each time, and its numbers come back from a journal") {
  const TemporaryFolder folder;
  const IntegrityRun run = driven(plain_drive(), folder.path());
  CHECK(run.is_right);
  CHECK(run.localized.wrong_s == 0);
  CHECK(run.localized.right_s > 10);
  CHECK(run.localized_after_m.value_or(1e9) < run.driven_m);
  CHECK(values_of(driven(plain_drive(), folder.path())) == values_of(run));
  CHECK(values_of(integrity_run_from(values_of(run))) == values_of(run));
}

TEST_CASE("a robot with another building's map is never right") {
  DrawnDrive drive = plain_drive();
  const TemporaryFolder folder;
  DriveWorld world = world_of(drive, robots(), folder.path());
  drive.building.seed = 77;
  world.map = world_of(drive, robots(), folder.path()).map;
  drive.duration_s = 15;
  const IntegrityRun run = run_drive(drive, world, robots());
  CHECK_FALSE(run.is_right);
  CHECK_FALSE(run.localized_after_m);
}

TEST_CASE("being carried is no driving, and recovery counts from the moment after") {
  DrawnDrive drive = plain_drive();
  drive.is_kidnapped = true;
  drive.duration_s = 40;
  const TemporaryFolder folder;
  const IntegrityRun run = driven(drive, folder.path());
  CHECK(run.driven_m < 40);
  REQUIRE(run.recovered_after_s);
  CHECK(*run.recovered_after_s >= 0);
  CHECK(*run.recovered_after_s <= 20);
}

TEST_CASE("every state of a map leaves one that a robot can be localized on") {
  const MapState state = GENERATE(MapState::plan, MapState::damaged, MapState::redrawn, MapState::learned);
  INFO(name_of(state));
  DrawnDrive drive = plain_drive();
  drive.map_state = state;
  drive.damage = 0.3;
  const TemporaryFolder folder;
  const DriveWorld world = world_of(drive, robots(), folder.path());
  CHECK(world.map->features().size() > 10);
  CHECK(world.map->features().size() != world.building->features().size());
  CHECK(std::filesystem::is_empty(folder.path()));
  const IntegrityRun run = run_drive(drive, world, robots());
  CHECK(run.answers > 50);
  CHECK_FALSE(run.is_false());
}

TEST_CASE("a robot on one of several storeys drives on the sheet of that storey") {
  DrawnDrive drive = plain_drive();
  drive.storeys = 3;
  drive.storey = 2;
  drive.building.symmetry = GENERATE(0.0, 1.0);
  const TemporaryFolder folder;
  const DriveWorld world = world_of(drive, robots(), folder.path());
  CHECK(world.map->origin().storeys.size() == 3);
  CHECK(world.building->features().size() < world.map->features().size());
  const Pose2 truth = recorded(drive, world, robots().two_lasers).scans.front().T_map_base;
  CHECK(place_in_building(*world.map, truth).storey == world.map->origin().storeys[2].id);
}

TEST_CASE("a campaign in parts, in any order and by any number of jobs, is the campaign") {
  const Campaign campaign = short_campaign(4);
  const TemporaryFolder whole_path, parts_path;
  const ab::ResultFolder whole(whole_path.path(), {{"campaign", 1}}), parts(parts_path.path(), {{"campaign", 1}});
  drive_all(campaign, whole, {1, 1}, 1);
  drive_all(campaign, parts, {2, 2}, 2);
  CHECK(judged_drives(campaign, parts).size() == 2);
  drive_all(campaign, parts, {1, 1}, 2);
  CHECK(values_in(campaign, whole).size() == 4);
  CHECK(values_in(campaign, parts) == values_in(campaign, whole));
}

TEST_CASE("a campaign that grows keeps its drives, and one that shrinks does not look at the others") {
  const TemporaryFolder path;
  const ab::ResultFolder folder(path.path(), {{"campaign", 1}});
  drive_all(short_campaign(1), folder, {1, 1}, 1);
  const auto first = values_in(short_campaign(1), folder);
  drive_all(short_campaign(2), folder, {1, 1}, 1);
  REQUIRE(values_in(short_campaign(2), folder).size() == 2);
  CHECK(values_in(short_campaign(2), folder).front() == first.front());
  drive_all(short_campaign(1), folder, {1, 1}, 1);
  CHECK(values_in(short_campaign(1), folder) == first);
}

TEST_CASE("a stopped campaign keeps what has ended, and goes on") {
  const Campaign campaign = short_campaign(3);
  const TemporaryFolder path;
  const ab::ResultFolder folder(path.path(), {{"campaign", 1}});
  std::stop_source stop;
  drive_campaign(
      campaign, robots(), folder, {1, 1}, 1,
      [&](std::size_t done, std::size_t) {
        if (done == 1) stop.request_stop();
      },
      stop.get_token());
  CHECK(judged_drives(campaign, folder).size() == 1);
  std::size_t first_done = 0;
  drive_campaign(campaign, robots(), folder, {1, 1}, 1,
                 [&](std::size_t done, std::size_t) {
                   if (first_done == 0) first_done = done;
                 },
                 {});
  CHECK(first_done >= 1);
  CHECK(judged_drives(campaign, folder).size() == 3);
}

TEST_CASE("a drive that cannot be driven is a result, with what happened") {
  const Campaign campaign = short_campaign(1);
  const PluginRegistry nothing;
  CampaignRobots without_plugins = robots();
  without_plugins.registry = &nothing;
  const TemporaryFolder path;
  const ab::ResultFolder folder(path.path(), {{"campaign", 1}});
  drive_campaign(campaign, without_plugins, folder, {1, 1}, 1, [](std::size_t, std::size_t) {}, {});
  const std::vector<JudgedDrive> drives = judged_drives(campaign, folder);
  REQUIRE(drives.size() == 1);
  CHECK_THAT(drives.front().failure, Contains("threw: ") && Contains("which no plugin offers"));
  CHECK(strata_of(drives).front().false_drives() == 1);
}

TEST_CASE("a repeated drive leaves its document, its events and a page") {
  DrawnDrive drive = plain_drive();
  drive.duration_s = 12;
  const TemporaryFolder folder;
  const ShownDrive shown = repeat_drive(drive, robots(), std::filesystem::path(folder.path()) / "worst");
  CHECK(values_of(shown.drive.run) == values_of(driven(drive, folder.path())));
  CHECK_THAT(shown.picture, Contains("<svg"));
  const std::filesystem::path left = std::filesystem::path(folder.path()) / "worst";
  CHECK(to_json(drawn_drive_from(nlohmann::json::parse(content_of((left / "drive.json").string())), "")) ==
        to_json(drive));
  CHECK_THAT(content_of((left / "page.html").string()), Contains("<html"));
  const std::string events = content_of((left / "events.jsonl").string());
  CHECK(events.find(R"("event":"truth")") <
        events.find(R"("event":"estimate")"));  // a page shows the truth beside each answer
}
