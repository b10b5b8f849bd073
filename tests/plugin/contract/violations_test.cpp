// The contracts themselves: small offenders, each of which breaks one promise.
#include <opal/plugin/testing/detector_contract.hpp>
#include <opal/plugin/testing/matcher_contract.hpp>
#include <opal/plugin/testing/pattern_contract.hpp>
#include <opal/plugin/testing/plugin_contract.hpp>
#include <opal/plugin/testing/reader_contract.hpp>
#include <opal/plugin/testing/scorer_contract.hpp>

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <atomic>
#include <functional>
#include <limits>

using namespace opal;
using Catch::Contains;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

struct Detector final : FeatureDetector {
  std::function<std::vector<Feature>(const Scan&)> find;
  std::vector<Feature> detect(const Scan& scan) const override { return find(scan); }
};

Feature post(const Point& position) {
  Feature feature;
  feature.type = "acme:Post";
  feature.geometry = position;
  feature.covariance.topLeftCorner<2, 2>() = 1e-4 * Eigen::Matrix2d::Identity();
  return feature;
}

/// An honest detector: the nearest point of the scan.
std::vector<Feature> nearest(const Scan& scan) {
  const ScanPoint* best = nullptr;
  for (const ScanPoint& point : scan.points)
    if (point.position.allFinite() && (best == nullptr || point.range_m < best->range_m)) best = &point;
  return best == nullptr ? std::vector<Feature>{} : std::vector<Feature>{post(best->position)};
}

std::vector<std::string> detector_offences(std::function<std::vector<Feature>(const Scan&)> find) {
  Detector detector;
  detector.find = std::move(find);
  return testing::detector_violations(detector, {"acme:PostDetector", {}, {"acme:Post"}});
}

/// The honest detector with each feature changed.
std::vector<std::string> detector_offences_with(std::function<void(Feature&)> change) {
  return detector_offences([change = std::move(change)](const Scan& scan) {
    std::vector<Feature> features = nearest(scan);
    for (Feature& feature : features) change(feature);
    return features;
  });
}

struct Pattern final : PatternTemplate {
  std::function<std::optional<PatternInstance>(const Circle&, const Circle&)> relate;
  PatternShape shape() const override { return {{GeometryKind::circle, GeometryKind::circle}, 5.0}; }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
    return relate(std::get<Circle>(features[0]->geometry), std::get<Circle>(features[1]->geometry));
  }
};

/// An honest pattern: two columns, the greater one first.
std::optional<PatternInstance> column_pair(const Circle& a, const Circle& b) {
  const Point way = b.center - a.center;
  if (!(a.radius_m > b.radius_m) || !(way.norm() > 0)) return std::nullopt;
  PatternInstance instance;
  instance.members = {0, 1};
  instance.invariants = {{way.norm(), 0.1, Comparison::equal}, {a.radius_m, 0.05, Comparison::equal}};
  instance.frame = {a.center, std::atan2(way.y(), way.x())};
  return instance;
}

std::vector<std::string> pattern_offences(
    std::function<std::optional<PatternInstance>(const Circle&, const Circle&)> relate) {
  Pattern pattern;
  pattern.relate = std::move(relate);
  return testing::pattern_violations(pattern, {"acme:ColumnPair", {"acme:Column"}, {}});
}

std::vector<std::string> pattern_offences_with(std::function<void(PatternInstance&, const Circle&)> change) {
  return pattern_offences([change = std::move(change)](const Circle& a, const Circle& b) {
    auto instance = column_pair(a, b);
    if (instance) change(*instance, a);
    return instance;
  });
}

/// The sentences as one text, to look for one of them.
std::string text(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& sentence : sentences) all += sentence + "\n";
  return all;
}

}  // namespace

TEST_CASE("an honest detector of a type that the framework does not know breaks no promise") {
  CHECK(text(detector_offences(nearest)) == "");
}

TEST_CASE("a detector that breaks a promise is told which") {
  CHECK_THAT(text(detector_offences([](const Scan&) -> std::vector<Feature> { throw std::runtime_error("no luck"); })),
             Contains("acme:PostDetector throws on an empty scan: no luck"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.type = "acme:Door"; })),
             Contains("of type \"acme:Door\", but it does not say that it produces these"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.geometry = Point(kNan, 0); })),
             Contains("is no possible shape"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) {
               f.geometry = Circle{{0, 0}, -1};
             })),
             Contains("is no possible shape"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance(0, 1) = kNan; })),
             Contains("has a covariance that is not finite"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance.setZero(); })),
             Contains("without a positive variance for each of its numbers"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance(0, 1) = f.covariance(1, 0) = 1; })),
             Contains("with a negative eigenvalue"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.covariance(2, 2) = 1; })),
             Contains("numbers in its unused third row"));
  CHECK_THAT(text(detector_offences_with([](Feature& f) { f.geometry = Point(1, 0); })),
             Contains("but not its like in example scan 0, turned by"));
}

TEST_CASE("a detector that remembers is told so") {
  auto calls = std::make_shared<std::atomic<int>>(0);
  CHECK_THAT(text(detector_offences_with([calls](Feature& f) { f.support_m = ++*calls; })),
             Contains("finds different features when it sees example scan 0 again; likely cause: a member that"));
}

TEST_CASE("a detector that must find something is told when it does not") {
  Detector detector;
  detector.find = [](const Scan&) { return std::vector<Feature>{}; };
  testing::DetectorTrial trial;
  trial.must_find_something = true;
  CHECK(text(testing::detector_violations(detector, {"acme:Blind", {}, {"acme:Post"}}, trial)) ==
        "acme:Blind finds nothing in any of the 5 scans\n");
}

TEST_CASE("an honest pattern over a type that the framework does not know breaks no promise") {
  CHECK(text(pattern_offences(column_pair)) == "");
}

TEST_CASE("a pattern that breaks a promise is told which") {
  const auto add_position = [](PatternInstance& i, const Circle& a) { i.invariants[0].value += a.center.x(); };
  CHECK_THAT(text(pattern_offences_with(add_position)), Contains("has an invariant 0 that a rigid motion changes"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle&) { i.frame = Pose2(); })),
             Contains("has a frame that does not move rigidly"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle&) {
               i.members = {0, 0};
             })),
             Contains("whose members are not each feature once"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle&) { i.invariants[1].tolerance = kNan; })),
             Contains("with a tolerance of nan"));
  CHECK_THAT(text(pattern_offences_with([](PatternInstance& i, const Circle& a) {
               if (a.radius_m > 0.3) i.invariants.pop_back();
             })),
             Contains("different numbers or comparisons of invariants"));
  CHECK_THAT(text(pattern_offences([](const Circle& a, const Circle& b) {
               return a.radius_m > b.radius_m ? column_pair(a, b) : column_pair(b, a);
             })),
             Contains("accepts a selection in two orders"));
  CHECK_THAT(text(pattern_offences([](const Circle&, const Circle&) { return std::nullopt; })),
             Contains("matches none of 3000 random selections"));
  CHECK_THAT(text(pattern_offences([](const Circle& a, const Circle& b) {
               return a.center.x() < b.center.x() ? column_pair(a, b) : std::nullopt;
             })),
             Contains("in one frame, but not in another"));
}

TEST_CASE("a matcher that claims what it cannot know is told so") {
  struct Sure final : ScanMatcher {
    ScanMatch match(std::span<const Point>, std::span<const Point>, const Pose2& guess,
                    const Eigen::Vector3d&) const override {
      return {guess, Eigen::Matrix3d::Identity(), 1, true};
    }
  };
  const std::string said = text(testing::matcher_violations(Sure(), {"acme:Sure", {}, {}}));
  CHECK_THAT(said, Contains("acme:Sure says that it has converged on two empty scans"));
  CHECK_THAT(said, Contains("says that it has converged on a scan of a room, but is 0.05") &&
                       Contains("expected at most 0.03 m and 0.015 rad; likely cause: the guess is returned"));
}

TEST_CASE("a reader that takes everything for its own is told so") {
  struct Taker final : LogSource {
    bool recognizes(const std::string&) const override { return true; }
    std::unique_ptr<LogReader> open(const std::string&) const override { throw ConfigError("no"); }
  };
  const std::string said = text(testing::log_source_violations(Taker(), {"acme:Taker", {}, {}}));
  CHECK_THAT(said, Contains("acme:Taker recognises a missing file as its own"));
  CHECK_THAT(said, Contains("refuses a missing file with an error of the wrong kind: no"));
}

TEST_CASE("a plugin that fails when it is called breaks its contract, with the file and the type named") {
  const std::string folder = std::string(OPAL_BAD_PLUGIN_DIR) + "/";
  CHECK_THAT(
      text(testing::plugin_violations(folder + "throws_in_detect.so")),
      Contains("throws_in_detect.so has a type that breaks its contract: bad:throws_in_detect throws on an empty "
               "scan: this detector fails on every scan"));
  CHECK_THAT(text(testing::plugin_violations(folder + "throws_in_match.so")),
             Contains("bad:throws_in_match throws on") && Contains("this pattern fails on every tuple"));
  CHECK_THAT(text(testing::plugin_violations(folder + "absent.so")),
             Contains("absent.so is refused: ") && Contains("there is no such file"));
}

TEST_CASE("a scorer that breaks a promise is told which") {
  struct Scorer final : HypothesisScorer {
    std::function<double(const Hypothesis&, const Observation&)> judge;
    bool by_associations = true;
    bool judges_associations() const override { return by_associations; }
    Score score(const Hypothesis& hypothesis, const Observation& seen, const MapView&,
                const ScorerMemory*) const override {
      return {judge(hypothesis, seen), "", {}};
    }
  };
  Scorer scorer;
  const auto offences = [&](auto&& judge) {
    scorer.judge = judge;
    return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}}));
  };
  CHECK(offences([](const Hypothesis& h, const Observation&) {
          return 0.1 * static_cast<double>(h.associations.size());
        }) == "");
  CHECK_THAT(offences([](const Hypothesis& h, const Observation&) { return h.T_map_local.x(); }),
             Contains("after map and hypothesis were moved together"));
  CHECK_THAT(offences([](const Hypothesis&, const Observation& seen) {
               return 1 - std::log(static_cast<double>(seen.points()));
             }),
             Contains("of an empty observation a score of inf"));
  double calls = 0;
  CHECK_THAT(offences([&](const Hypothesis&, const Observation&) { return ++calls; }),
             Contains("another score when it is asked again"));
  scorer.by_associations = false;
  CHECK_THAT(offences([](const Hypothesis& h, const Observation&) {
               return 0.1 * static_cast<double>(h.associations.size());
             }),
             Contains("another score than without its associations, which it says it does not judge"));
  CHECK(offences([](const Hypothesis&, const Observation& seen) { return static_cast<double>(seen.points()); }) == "");
}

TEST_CASE("a scorer that judges many hypotheses otherwise than one is told so") {
  struct Scorer final : HypothesisScorer {
    double surplus_nat = 0;
    std::size_t surplus_scores = 0;
    Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
      return {1, {}, {}};
    }
    std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses, std::span<const ScorerMemory* const>,
                                 const Observation&, const MapView&) const override {
      return std::vector<Score>(hypotheses.size() + surplus_scores, Score{1 + surplus_nat, {}, {}});
    }
  };
  Scorer scorer;
  const auto offences = [&] { return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}})); };
  CHECK(offences() == "");
  scorer.surplus_nat = 0.001;
  CHECK_THAT(offences(), Contains("gives the true hypothesis another score when it judges many in one call"));
  scorer.surplus_nat = 0;
  scorer.surplus_scores = 1;
  CHECK_THAT(offences(), Contains("gives 8 scores for 7 hypotheses in one call"));
}

TEST_CASE("a scorer that explains itself badly is told so") {
  struct Scorer final : HypothesisScorer {
    Finding finding;
    Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
      return {};
    }
    std::vector<Finding> explain(const Hypothesis&, const Observation&, const MapView&) const override {
      return {finding};
    }
  };
  const auto offences = [](const Finding& finding) {
    Scorer scorer;
    scorer.finding = finding;
    return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}}));
  };
  CHECK(offences({"a beam passes through a wall", MapFeatureNumber(0), {{0, 0}, {1, 0}}}) == "");
  CHECK_THAT(offences({"", {}, {}}), Contains("a finding without words"));
  CHECK_THAT(offences({"something", MapFeatureNumber(100000), {}}), Contains("a mapped feature that does not exist"));
  CHECK_THAT(offences({"something", {}, {{0, 0}, {kNan, 0}}}), Contains("not two finite points"));
}

namespace {

/// How many scans a hypothesis has seen. Broken ones share the count between copies.
struct Count final : ScorerMemory {
  std::shared_ptr<double> scans = std::make_shared<double>(0);
  std::function<std::unique_ptr<ScorerMemory>(const Count&)> copied = independent;

  static std::unique_ptr<ScorerMemory> independent(const Count& count) {
    auto copy = std::make_unique<Count>(count);
    copy->scans = std::make_shared<double>(*count.scans);
    return copy;
  }
  std::unique_ptr<ScorerMemory> copy() const override { return copied(*this); }
};

/// An honest scorer with a memory, whose single steps can be replaced by broken ones.
struct CountingScorer final : HypothesisScorer {
  std::function<std::unique_ptr<ScorerMemory>()> make = [] { return std::make_unique<Count>(); };
  std::function<double(double&)> judge = [](double& scans) { return 1 / (1 + scans); };
  std::function<void(double&, double)> add = [](double& scans, double weight) { scans += weight; };
  std::function<void(double&, double)> forget = [](double& scans, double weight) { scans *= 1 - 0.1 * weight; };

  static double& scans_of(const ScorerMemory& memory) { return *dynamic_cast<const Count&>(memory).scans; }
  std::unique_ptr<ScorerMemory> new_memory(const MapView&) const override { return make(); }
  Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory* memory) const override {
    double nothing = 0;
    return {judge(memory ? scans_of(*memory) : nothing), "", {}, std::make_shared<Count>()};
  }
  void remember(ScorerMemory& memory, const ScorerMemory&, double weight) const override {
    add(scans_of(memory), weight);
  }
  void fade(ScorerMemory& memory, double weight) const override { forget(scans_of(memory), weight); }
};

std::string memory_offences(const std::function<void(CountingScorer&)>& change) {
  CountingScorer scorer;
  change(scorer);
  return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}}));
}

/// The offences of a scorer whose memory copies itself in this way.
std::string copy_offences(std::function<std::unique_ptr<ScorerMemory>(const Count&)> copied) {
  return memory_offences([&](CountingScorer& scorer) {
    scorer.make = [copied] {
      auto count = std::make_unique<Count>();
      count->copied = copied;
      return count;
    };
  });
}

}  // namespace

TEST_CASE("an honest scorer with a memory breaks no promise") {
  CHECK(memory_offences([](CountingScorer&) {}) == "");
}

TEST_CASE("a scorer whose memory does not copy itself well is told so") {
  struct Other final : ScorerMemory {
    std::unique_ptr<ScorerMemory> copy() const override { return std::make_unique<Other>(); }
  };
  CHECK_THAT(copy_offences([](const Count&) { return nullptr; }), Contains("a memory whose copy is null"));
  CHECK_THAT(copy_offences([](const Count&) { return std::make_unique<Other>(); }),
             Contains("a memory whose copy is of another type"));
  CHECK_THAT(copy_offences([](const Count&) { return std::make_unique<Count>(); }),
             Contains("another score with a copy of its memory"));
  CHECK_THAT(copy_offences([](const Count& count) { return std::make_unique<Count>(count); }),
             Contains("another score after a copy of its memory has remembered a scan and faded"));
}

TEST_CASE("a scorer that uses its memory badly is told how") {
  CHECK_THAT(memory_offences([](CountingScorer& s) { s.judge = [](double& scans) { return ++scans; }; }),
             Contains("another score when the same memory is used again"));
  CHECK_THAT(
      memory_offences([](CountingScorer& s) { s.add = [](double&, double) { throw std::runtime_error("full"); }; }),
      Contains("throws on remembering a scan of the true hypothesis: full"));
  CHECK_THAT(
      memory_offences([](CountingScorer& s) { s.forget = [](double&, double) { throw std::runtime_error("never"); }; }),
      Contains("throws on fading the memory of the true hypothesis: never"));
  CHECK_THAT(
      memory_offences([](CountingScorer& s) { s.forget = [](double& scans, double weight) { scans /= 1 - weight; }; }),
      Contains("after it has remembered some scans"));
}

TEST_CASE("a scorer that cannot make up its mind about having a memory is told so") {
  CHECK_THAT(memory_offences([](CountingScorer& s) { s.make = [] { return nullptr; }; }),
             Contains("says what it has seen of the true hypothesis, but makes no new memory to remember it in"));
  int made = 0;
  CHECK_THAT(memory_offences([&](CountingScorer& s) {
               s.make = [&]() -> std::unique_ptr<ScorerMemory> {
                 return ++made % 2 == 0 ? std::make_unique<Count>() : nullptr;
               };
             }),
             Contains("makes a new memory of a map at one time and none at another"));
}
