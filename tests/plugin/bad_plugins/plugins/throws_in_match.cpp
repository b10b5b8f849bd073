#include <opal/plugin/plugin.hpp>

#include <stdexcept>

namespace {

class ThrowingPattern final : public opal::PatternTemplate {
 public:
  explicit ThrowingPattern(const nlohmann::json&) {}
  opal::PatternShape shape() const override { return {{opal::GeometryKind::segment}, 5.0}; }
  std::optional<opal::PatternInstance> match(std::span<const opal::Feature* const>) const override {
    throw std::runtime_error("this pattern fails on every tuple");
  }
};

void register_types(opal::Registrar& registrar) { registrar.add<ThrowingPattern>({.name = "bad:throws_in_match"}); }

}  // namespace

OPAL_PLUGIN("throws_in_match", "1.2.3", register_types)
