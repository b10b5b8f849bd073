#include <opal/plugin/registrar.hpp>

#include <catch2/catch.hpp>

#include <map>

using namespace opal;

namespace {

/// Remembers the scorers and detectors that are registered.
class Listing final : public Registrar {
 public:
  using Registrar::add;
  void add(TypeInfo type, Factory<FeatureDetector> make) override { detectors[type.name] = {type, make}; }
  void add(TypeInfo, Factory<PatternTemplate>) override { FAIL("a pattern was registered"); }
  void add(TypeInfo type, Factory<HypothesisScorer> make) override { scorers[type.name] = {type, make}; }
  void add(TypeInfo, Factory<LogSource>) override { FAIL("a log source was registered"); }
  void add(TypeInfo, Factory<MapImporter>) override { FAIL("an importer was registered"); }
  void add(TypeInfo, Factory<ScanMatcher>) override { FAIL("a matcher was registered"); }
  void add(TypeInfo, Factory<MapStore>) override { FAIL("a store was registered"); }

  std::map<std::string, std::pair<TypeInfo, Factory<FeatureDetector>>> detectors;
  std::map<std::string, std::pair<TypeInfo, Factory<HypothesisScorer>>> scorers;
};

/// Says what it was made of.
struct Sum final : HypothesisScorer {
  explicit Sum(const nlohmann::json& options) : nat(options.at("nat")) {}
  Sum(int more, double still_more, const nlohmann::json& options)
      : nat(more + still_more + double(options.at("nat"))) {}
  Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
    return {nat, {}, {}};
  }
  double nat;
};

struct Blind final : FeatureDetector {
  struct Options {
    std::string why;
  };
  explicit Blind(Options given) : options(std::move(given)) {}
  std::vector<Feature> detect(const Scan&) const override { return {}; }
  Options options;
};

}  // namespace

TEST_CASE("a class is registered by its interface, under its name, with what it works on") {
  Listing listing;
  Registrar& registrar = listing;
  registrar.add<Sum>({.name = "acme:Sum", .consumes = {"acme:A"}, .produces = {"acme:B"}});
  REQUIRE(listing.scorers.size() == 1);
  const auto& [info, make] = listing.scorers.at("acme:Sum");
  CHECK(info.consumes == std::vector<std::string>{"acme:A"});
  CHECK(info.produces == std::vector<std::string>{"acme:B"});
  CHECK(dynamic_cast<const Sum&>(*make({{"nat", 2}})).nat == 2);
  CHECK(listing.detectors.empty());
}

TEST_CASE("arguments of a registration come before the options") {
  Listing listing;
  Registrar& registrar = listing;
  registrar.add<Sum>({.name = "acme:Sum"}, 10, 0.5);
  CHECK(dynamic_cast<const Sum&>(*listing.scorers.at("acme:Sum").second({{"nat", 2}})).nat == 12.5);
}

TEST_CASE("a function of a registration reads the options") {
  Listing listing;
  Registrar& registrar = listing;
  registrar.add<Blind>({.name = "acme:Blind"},
                       [](const nlohmann::json& options) { return Blind::Options{options.at("why")}; });
  const auto made = listing.detectors.at("acme:Blind").second({{"why", "it is dark"}});
  CHECK(dynamic_cast<const Blind&>(*made).options.why == "it is dark");
}
