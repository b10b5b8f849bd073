#include "patterns/consuming_template.hpp"

#include <algorithm>
#include <utility>

namespace opal {
namespace {

class ConsumingTemplate final : public PatternTemplate {
 public:
  ConsumingTemplate(std::shared_ptr<const PatternTemplate> inner, std::vector<std::string> consumes)
      : inner_(std::move(inner)), consumes_(std::move(consumes)) {}

  PatternShape shape() const override { return inner_->shape(); }

  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
    const auto is_consumed = [&](const Feature* feature) {
      return std::find(consumes_.begin(), consumes_.end(), feature->type) != consumes_.end();
    };
    return std::all_of(features.begin(), features.end(), is_consumed) ? inner_->match(features) : std::nullopt;
  }

 private:
  std::shared_ptr<const PatternTemplate> inner_;
  std::vector<std::string> consumes_;
};

}  // namespace

std::shared_ptr<const PatternTemplate> consuming(std::shared_ptr<const PatternTemplate> pattern_template,
                                                 std::vector<std::string> consumes) {
  if (consumes.empty()) return pattern_template;
  return std::make_shared<const ConsumingTemplate>(std::move(pattern_template), std::move(consumes));
}

}  // namespace opal
