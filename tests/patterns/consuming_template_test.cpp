#include "tests/kit/shipped_plugins.hpp"

#include "patterns/consuming_template.hpp"

#include <opal/deployment/deployment.hpp>
#include <opal/plugin/testing/scorer_contract.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;

namespace {

/// Any one point.
class AnyPoint final : public PatternTemplate {
 public:
  PatternShape shape() const override { return {{GeometryKind::point}}; }
  std::optional<PatternInstance> match(std::span<const Feature* const>) const override {
    PatternInstance instance;
    instance.members = {0};
    return instance;
  }
};

bool takes(const PatternTemplate& pattern_template, const std::string& type, const Geometry& geometry) {
  const Feature feature{.type = type, .geometry = geometry};
  const std::vector<const Feature*> one{&feature};
  return pattern_template.match(one).has_value();
}

}  // namespace

TEST_CASE("a template that consumes some types takes no feature of another type, though its geometry fits") {
  const auto any = std::make_shared<const AnyPoint>();
  CHECK(takes(*consuming(any, {"acme:Doorway"}), "acme:Doorway", Point(1, 2)));
  CHECK_FALSE(takes(*consuming(any, {"acme:Doorway"}), "acme:Post", Point(1, 2)));
  CHECK(takes(*consuming(any, {}), "acme:Post", Point(1, 2)));
}

TEST_CASE("the templates of a localizer keep to the types that they consume") {
  const Deployment deployment = parse_deployment(
      R"({"@context": "urn:opal:v1", "@type": "opal:Deployment", "scorers": [{"@type": "opal:Beams"}]})", "a.jsonld");
  const LocalizerParts parts = build_parts(deployment, shipped_plugins(), opal::testing::example_map());
  const auto pose = std::find_if(parts.patterns.begin(), parts.patterns.end(),
                                 [](const auto& pattern) { return pattern.name == "opal:CornerPose"; });
  REQUIRE(pose != parts.patterns.end());
  const OrientedPoint corner{Point(1, 2), 0.5, std::numbers::pi / 2};
  CHECK(takes(*pose->part, "opal:Corner", corner));
  CHECK_FALSE(takes(*pose->part, "acme:Hinge", corner));
}
