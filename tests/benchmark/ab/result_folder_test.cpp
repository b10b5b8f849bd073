#include "small_experiment.hpp"

#include "tests/system/server/program.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace opal::ab_tests;
using nlohmann::json;
using opal::TemporaryFolder;
using opal::store_tests::Finished;
using opal::store_tests::opal_run;

namespace {

namespace fs = std::filesystem;

void compute_all(const std::string& experiment, const std::string& out) {
  const Finished run = opal_run({"ab", experiment, "-o", out});
  INFO(run.said);
  REQUIRE(run.exit_code == 0);
}

}  // namespace

TEST_CASE("results of other arms, plugins or maps are not mixed") {
  const TemporaryFolder folder;
  json document = small_experiment();
  const std::string experiment = written(folder, document), out = folder.path_of("out");
  compute_all(experiment, out);
  document["arms"][1]["overrides"]["scorers"][0]["options"] = {{"horizon", 7}};
  written(folder, document);
  const Finished other = opal_run({"ab", experiment, "-o", out});
  CHECK(other.exit_code == 3);
  CHECK_THAT(other.said, Catch::Contains(out + "/manifest.json: /arms/1/configuration/scorers/0"));
  CHECK_THAT(other.said, Catch::Contains("give another folder"));
}

TEST_CASE("results of a plugin whose description was changed are not mixed") {
  const TemporaryFolder folder;
  fs::copy(OPAL_FAULTY_PLUGIN_DIR, folder.path_of("plugins"));
  json document = small_experiment();
  document["sites"][0]["queries"] = {"malaga-demo-q01"};
  document["arms"].push_back({{"name", "mine"}, {"overrides", {{"scorers", {{{"@type", "faulty:Scorer"}}}}}}});
  document["arms"][2]["plugins"] = folder.path_of("plugins");
  document["arms"][2]["overrides"]["scorers"][0]["options"] = {{"how", "no fault"}};
  const std::string experiment = written(folder, document), out = folder.path_of("out");
  compute_all(experiment, out);
  json description = json::parse(content_of(folder.path_of("plugins/faulty.jsonld")));
  description["types"][0]["options"][1]["default"] = 2;
  folder.write("plugins/faulty.jsonld", description.dump());
  const Finished other = opal_run({"ab", experiment, "-o", out});
  CHECK(other.exit_code == 3);
  CHECK_THAT(other.said, Catch::Contains("/description_sha256: was "));
}

TEST_CASE("a plugin that came to an arm's plugins, or went, is named") {
  const TemporaryFolder folder;
  json document = small_experiment();
  document["sites"][0]["queries"] = {"malaga-demo-q01"};
  const std::string experiment = written(folder, document), out = folder.path_of("out");
  compute_all(experiment, out);
  document["arms"][0]["plugins"] = OPAL_FAULTY_PLUGIN_DIR;
  written(folder, document);
  const Finished more = opal_run({"ab", experiment, "-o", out});
  CHECK(more.exit_code == 3);
  CHECK_THAT(more.said, Catch::Contains(": was absent for the results in this folder and is \"faulty\" now"));
}

TEST_CASE("how far an experiment is can be asked without a job array") {
  const TemporaryFolder folder;
  const std::string experiment = written(folder, small_experiment()), out = folder.path_of("out");
  REQUIRE(opal_run({"ab", "work", experiment, "-o", out, "--shard", "1/5"}).exit_code == 0);
  const Finished status = opal_run({"ab", "status", experiment, "-o", out});
  CHECK(status.exit_code == 1);
  CHECK_THAT(status.said, Catch::Contains("2 of 10 cells are finished") && !Catch::Contains("job"));
}
