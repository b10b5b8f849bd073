#include "small_experiment.hpp"

#include "benchmark/ab/documents/experiment.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "jsonld/json_ld.hpp"
#include "tests/kit/refusal.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace opal::ab;
using nlohmann::json;
using opal::TemporaryFolder;
using opal::ab_tests::content_of;
using opal::ab_tests::written;

namespace {

std::string shipped(const std::string& name) { return std::string(OPAL_SOURCE_DIR) + "/configs/" + name + ".jsonld"; }

/// What a document is refused with, from its place on.
std::string refusal_of(const json& document) {
  const TemporaryFolder folder;
  const std::string path = written(folder, document);
  const std::string message = opal::refused_with<opal::Error>([&] { read_experiment(path, shipped); });
  return message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
}

std::string refusal_with(const json::json_pointer& place, const json& value) {
  json document = opal::ab_tests::experiment_with_drives();
  document[place] = value;
  return refusal_of(document);
}

}  // namespace

TEST_CASE("an experiment is read with the deployments that it names") {
  const TemporaryFolder folder;
  json document = opal::ab_tests::experiment_with_drives();
  document["baseline"] = "lack_of_fit";
  document["arms"][0]["overrides"]["stages"] = {{"hypotheses", {{"max_hypotheses", 50}}}};
  const Experiment experiment = read_experiment(written(folder, document), shipped);
  REQUIRE(experiment.arms.size() == 2);
  CHECK(experiment.baseline == 1);
  CHECK(experiment.arms[0].deployment.scorers.at(0).part.type == "opal:Evidence");
  CHECK(experiment.arms[0].deployment.stages.hypotheses.max_hypotheses == 50);
  CHECK(experiment.arms[0].deployment.matcher->type == "opal:PointToLineMatcher");  // as configs/default.jsonld has it
  REQUIRE(experiment.scenarios.size() == 2);
  CHECK(experiment.scenarios[0].name == "malaga-demo");
  CHECK(experiment.scenarios[0].seeds.size() == 1);
  CHECK(experiment.scenarios[1].seeds.size() == 3);
  CHECK(std::get<SimulatedDrives>(experiment.scenarios[1].source).drives.drives == 2);
  CHECK(experiment.limits.wall_s == 100);
}

TEST_CASE("the experiment of the documentation is JSON-LD of Opal's vocabulary") {
  opal::json_ld::Options options;
  options.contexts["urn:opal:v1"] = opal::read_json(OPAL_SOURCE_DIR "/maps/context/opal.jsonld");
  options.reject_unknown_terms = true;
  const std::string path = OPAL_SOURCE_DIR "/docs/examples/outside_scorer/three_scorers.jsonld";
  const json expanded = opal::json_ld::expand(opal::read_json(path), options);
  REQUIRE(expanded.size() == 1);
  CHECK(expanded[0]["@type"][0] == "urn:opal:v1#Experiment");
  CHECK(expanded[0]["urn:opal:v1#arms"][0]["@value"].size() == 3);
}

TEST_CASE("paths of a document start where it stands") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path_of("plugins"));
  folder.write("mine.jsonld", content_of(shipped("default")));
  json document = opal::ab_tests::small_experiment();
  document["arms"][1] = {{"name", "mine"}, {"deployment", "mine.jsonld"}, {"plugins", {"plugins"}}};
  document["sites"][0]["prefix"] = "logs/here";
  std::filesystem::create_directory(folder.path_of("logs"));
  folder.write("logs/here.queries.json", "{}");
  const Experiment experiment = read_experiment(written(folder, document), shipped);
  CHECK(std::get<RecordedPlace>(experiment.scenarios[0].source).prefix == folder.path_of("logs/here"));
  CHECK(experiment.arms[1].plugin_folders == std::vector<std::string>{folder.path_of("plugins")});
}

TEST_CASE("several buildings of a kind are several scenarios") {
  const TemporaryFolder folder;
  json document = opal::ab_tests::experiment_with_drives();
  document["simulated"][0]["buildings"] = 3;
  const Experiment experiment = read_experiment(written(folder, document), shipped);
  REQUIRE(experiment.scenarios.size() == 4);
  CHECK(experiment.scenarios[1].name == "corridor-1");
  CHECK(experiment.scenarios[3].name == "corridor-3");
  CHECK(std::get<SimulatedDrives>(experiment.scenarios[3].source).building->seed == 3);
}

TEST_CASE("a simulated drive reads what stands along the walls") {
  const TemporaryFolder folder;
  json document = opal::ab_tests::experiment_with_drives();
  document["simulated"][0]["along_walls"] = 0.6;
  const Experiment experiment = read_experiment(written(folder, document), shipped);
  CHECK(std::get<SimulatedDrives>(experiment.scenarios[1].source).world.clutter.along_walls == 0.6);
  using P = json::json_pointer;
  for (const double share : {-0.1, 0.96})
    CHECK_THAT(refusal_with(P("/simulated/0/along_walls"), share),
               Catch::StartsWith("/simulated/0/along_walls: ") && Catch::Contains("expected a number from 0 to 0.95"));
}

TEST_CASE("what an experiment must not be is refused with its place") {
  using P = json::json_pointer;
  CHECK_THAT(refusal_with(P("/arm"), 1), Catch::StartsWith("/arm: unknown key, expected one of: "));
  CHECK_THAT(refusal_with(P("/arms/0/deploiment"), "default"), Catch::StartsWith("/arms/0/deploiment: unknown key"));
  CHECK_THAT(refusal_with(P("/sites/0/seed"), 1), Catch::StartsWith("/sites/0/seed: unknown key"));
  CHECK_THAT(refusal_with(P("/simulated/0/building/size"), 1),
             Catch::StartsWith("/simulated/0/building/size: unknown key"));
  CHECK_THAT(refusal_with(P("/limits/cell_s"), 0), Catch::StartsWith("/limits/cell_s: 0, expected a number from"));
  CHECK_THAT(refusal_with(P("/arms"), json::array()),
             Catch::StartsWith("/arms: [], expected a list of at least two arms"));
  CHECK(refusal_with(P("/arms/1/name"), "evidence") ==
        "/arms/1/name: \"evidence\", expected a name that no other arm has");
  CHECK(refusal_with(P("/arms/1/name"), "a/b") ==
        "/arms/1/name: \"a/b\", expected a name of letters, digits, _, - and .");
  CHECK(refusal_with(P("/baseline"), "c") == "/baseline: \"c\", expected the name of an arm: evidence, lack_of_fit");
  CHECK(refusal_with(P("/sites/0/seeds"), 3) ==
        "/sites/0/seeds: 3, expected no seeds: without damage, a recording is the same for every seed");
  CHECK_THAT(refusal_with(P("/sites/0/damage"), "drip=1"), Catch::StartsWith("/sites/0/damage: "));
  CHECK_THAT(refusal_with(P("/simulated/0/map"), "a.jsonld"),
             Catch::StartsWith("/simulated/0/map: \"a.jsonld\", expected either a map or a building"));
  CHECK_THAT(refusal_with(P("/simulated/0/challenge"), "Z1"),
             Catch::StartsWith("/simulated/0/challenge: \"Z1\", expected A1"));
  CHECK_THAT(refusal_with(P("/simulated/0/name"), "malaga-demo"),
             Catch::Contains("expected a name that no other scenario has"));
  CHECK_THAT(refusal_with(P("/arms/0/plugins"), "nowhere"), Catch::Contains("expected a folder"));
  CHECK_THAT(refusal_with(P("/sites/0/prefix"), "malaga-dmo"),
             Catch::StartsWith("/sites/0/prefix: \"malaga-dmo\", expected the prefix of a recorded place: ") &&
                 Catch::EndsWith("malaga-dmo.queries.json does not exist"));
}

TEST_CASE("a misspelt key is named, not the key that is absent for it") {
  json document = opal::ab_tests::small_experiment();
  document["site"] = document["sites"];
  document.erase("sites");
  CHECK(refusal_of(document) == "/site: unknown key, did you mean \"sites\"?");
  document.erase("site");
  CHECK_THAT(refusal_of(document), Catch::StartsWith("/sites: absent, expected "));
}

TEST_CASE("an arm's overrides are read as strictly as a deployment, and named") {
  using P = json::json_pointer;
  CHECK_THAT(refusal_with(P("/arms/0/overrides/scorer"), 1),
             Catch::Contains("default.jsonld (with the overrides of arm evidence): /scorer: unknown key"));
}

TEST_CASE("arms that shall observe differ by their scorers only") {
  json document = opal::ab_tests::small_experiment();
  document["mode"] = "observe";
  CHECK(refusal_of(document) == "accepted");
  document["arms"][1]["overrides"]["stages"] = {{"hypotheses", {{"max_hypotheses", 50}}}};
  CHECK_THAT(
      refusal_of(document),
      Catch::StartsWith("/mode: \"observe\", but arm lack_of_fit differs from evidence by more than its scorers"));
  document["mode"] = "look";
  CHECK(refusal_of(document) == "/mode: \"look\", expected \"decide\" or \"observe\"");
}

TEST_CASE("arms that are not given the same are refused") {
  using P = json::json_pointer;
  CHECK_THAT(refusal_with(P("/arms/1/overrides/map"), "b.jsonld"),
             Catch::Contains("arm lack_of_fit has another \"map\" than evidence, expected the same inputs"));
  CHECK_THAT(refusal_with(P("/arms/1/overrides/sensor"), {{"id", "Other"}}), Catch::Contains("another \"sensor\""));
  CHECK_THAT(refusal_with(P("/arms/1/overrides/overlays"), {"b.jsonld"}), Catch::Contains("another \"overlays\""));
}
