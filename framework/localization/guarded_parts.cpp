#include "localization/guarded_parts.hpp"

#include "patterns/sound_instance.hpp"

#include <utility>

namespace opal {
namespace {

class GuardedTemplate final : public PatternTemplate {
 public:
  GuardedTemplate(const Named<PatternTemplate>& guarded, PluginFailures& failures)
      : name_(guarded.name), template_(guarded.part), failures_(failures) {}

  PatternShape shape() const override { return template_->shape(); }
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override {
    std::optional<PatternInstance> found;
    const bool is_sound = failures_.guard(name_, [&] {
      found = template_->match(features);
      if (found) expect_sound(*found, features.size());
    });
    return is_sound ? found : std::nullopt;
  }

 private:
  std::string name_;
  std::shared_ptr<const PatternTemplate> template_;
  PluginFailures& failures_;
};

class GuardedMatcher final : public ScanMatcher {
 public:
  GuardedMatcher(std::shared_ptr<const ScanMatcher> guarded, PluginFailures& failures)
      : matcher_(std::move(guarded)), failures_(failures) {}

  ScanMatch match(std::span<const Point> reference, std::span<const Point> scan, const Pose2& guess,
                  const Eigen::Vector3d& guess_sigma) const override {
    ScanMatch match;
    match.T_reference_scan = guess;
    failures_.guard("scan matcher", [&] { match = matcher_->match(reference, scan, guess, guess_sigma); });
    return match;
  }

 private:
  std::shared_ptr<const ScanMatcher> matcher_;
  PluginFailures& failures_;
};

}  // namespace

LocalizerParts guarded(LocalizerParts parts, PluginFailures& failures) {
  for (Named<PatternTemplate>& each : parts.patterns) each.part = std::make_shared<GuardedTemplate>(each, failures);
  if (parts.matcher) parts.matcher = std::make_shared<GuardedMatcher>(std::move(parts.matcher), failures);
  return parts;
}

}  // namespace opal
