#include "deployment/localizer_options.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("options of stages are read by name, and what is not named keeps its default") {
  const LocalizerOptions options =
      read_localizer_options({{"search", {{"patterns", 4}, {"region", {{"x_m", 1.0}, {"y_m", -2}, {"radius_m", 5}}}}},
                              {"tracking", {{"evidence_memory", 0.9}}},
                              {"growth", {{"branch_not_on_map", true}}}},
                             "a.jsonld: /stages");
  CHECK(options.search.patterns == 4);
  CHECK(options.search.places == SearchOptions().places);
  CHECK(options.tracking.evidence_memory == 0.9);
  CHECK(options.growth.branch_not_on_map);
  REQUIRE(options.search.region);
  CHECK(options.search.region->center == Point(1, -2));
}

TEST_CASE("a wrong option of a stage is refused with its place, what was found and what is expected") {
  const auto message = [](const nlohmann::json& stages) -> std::string {
    return refused_with<ConfigError>([&] { read_localizer_options(stages, "a.jsonld: /stages"); });
  };
  CHECK_THAT(
      message({{"serach", nlohmann::json::object()}}),
      Catch::StartsWith("a.jsonld: /stages/serach: unknown stage, expected one of: tempering, schedule, search,"));
  CHECK_THAT(
      message({{"tracking", {{"memmory", 0.9}}}}),
      Catch::StartsWith("a.jsonld: /stages/tracking/memmory: unknown option, expected one of: evidence_memory,"));
  CHECK(message({{"tracking", 7}}) == "a.jsonld: /stages/tracking: 7, expected an object of options");
  CHECK(message({{"tracking", {{"evidence_memory", 1.5}}}}) ==
        "a.jsonld: /stages/tracking/evidence_memory: 1.5, expected a number from 0.0 to 1.0");
  CHECK(message({{"growth", {{"max_branches", 1.5}}}}) ==
        "a.jsonld: /stages/growth/max_branches: 1.5, expected an integer from 1 to 1000");
  CHECK(message({{"growth", {{"branch_not_on_map", 1}}}}) ==
        "a.jsonld: /stages/growth/branch_not_on_map: 1, expected true or false");
  CHECK(message({{"search", {{"region", {{"x_m", 1}}}}}}) ==
        "a.jsonld: /stages/search/region: {\"x_m\":1}, expected an object with x_m, y_m and radius_m");
}

TEST_CASE("every option of every stage is described, and its default is what the struct holds") {
  const std::vector<DescribedStage> stages = describe_stages();
  CHECK(stages.size() == 10);
  nlohmann::json document;
  for (const DescribedStage& stage : stages) {
    CHECK_FALSE(stage.description.empty());
    CHECK_FALSE(stage.options.empty());
    for (const OptionInfo& option : stage.options) {
      INFO(stage.name << "/" << option.name);
      CHECK_THAT(option.description, Catch::Matches("[A-Z].{20,}\\."));  // sentences that stand alone
      if (!option.default_value.is_null()) document[stage.name][option.name] = option.default_value;
    }
  }
  const LocalizerOptions read = read_localizer_options(document, "defaults");  // defaults are in range
  CHECK(read.search.lookup_limit == SearchOptions().lookup_limit);
  CHECK(read.status.localized_weight == StatusOptions().localized_weight);
  CHECK(read.kidnapping.prior_nat == KidnappingOptions().prior_nat);
}
