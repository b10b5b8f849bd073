#include "localization/guarded_parts.hpp"

#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace opal;
using namespace opal::synthetic;

namespace {

struct ThrowingTemplate : CornerTemplate {
  std::optional<PatternInstance> match(std::span<const Feature* const>) const override {
    throw std::runtime_error("of a template");
  }
};

struct ThrowingMatcher : ScanMatcher {
  ScanMatch match(std::span<const Point>, std::span<const Point>, const Pose2&, const Eigen::Vector3d&) const override {
    throw std::runtime_error("of a matcher");
  }
};

}  // namespace

TEST_CASE("what a template throws is counted, and it has found nothing") {
  PluginFailures failures;
  LocalizerParts parts;
  parts.patterns = {{"throwing", std::make_shared<ThrowingTemplate>()}, {"sound", std::make_shared<CornerTemplate>()}};
  parts = guarded(std::move(parts), failures);
  const Feature corner{"opal:Corner", OrientedPoint{{1, 2}, 0.3, 1.5}};
  const Feature* const offered = &corner;
  for (int k = 0; k < 3; ++k) CHECK_FALSE(parts.patterns[0].part->match({&offered, 1}));
  CHECK(parts.patterns[0].part->shape().slots == CornerTemplate().shape().slots);
  CHECK(parts.patterns[1].part->match({&offered, 1}));
  CHECK(failures.counts() == std::map<std::string, int>{{"throwing", 3}});
}

TEST_CASE("a pattern of features that nobody offered is counted, and nothing is found") {
  struct Wrong : CornerTemplate {
    std::vector<int> members;
    double value = 1;
    std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
      auto found = CornerTemplate::match(features);
      found->members = members;
      found->invariants = {{value, 0.1}};
      return found;
    }
  };
  const auto wrong = std::make_shared<Wrong>();
  PluginFailures failures;
  LocalizerParts parts;
  parts.patterns = {{"wrong", wrong}};
  parts = guarded(std::move(parts), failures);
  const Feature corner{"opal:Corner", OrientedPoint{{1, 2}, 0.3, 1.5}};
  const Feature* const offered = &corner;
  for (const std::vector<int>& members : {std::vector<int>{}, {7}, {-1}, {0, 0}}) {
    wrong->members = members;
    CHECK_FALSE(parts.patterns[0].part->match({&offered, 1}));
  }
  wrong->members = {0};
  CHECK(parts.patterns[0].part->match({&offered, 1}));
  wrong->value = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(parts.patterns[0].part->match({&offered, 1}));
  CHECK(failures.counts() == std::map<std::string, int>{{"wrong", 5}});
}

TEST_CASE("what a scan matcher throws is counted, and odometry is kept") {
  PluginFailures failures;
  LocalizerParts parts;
  parts.matcher = std::make_shared<ThrowingMatcher>();
  parts = guarded(std::move(parts), failures);
  const Pose2 guess(1, 2, 0.3);
  const ScanMatch match = parts.matcher->match({}, {}, guess, {1, 1, 1});
  CHECK_FALSE(match.converged);
  CHECK(distance_m(match.T_reference_scan, guess) == 0);
  CHECK(failures.counts() == std::map<std::string, int>{{"scan matcher", 1}});
}

TEST_CASE("a localizer without a scan matcher stays without one") {
  PluginFailures failures;
  CHECK_FALSE(guarded(LocalizerParts(), failures).matcher);
}
