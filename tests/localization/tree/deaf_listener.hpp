#pragma once

#include "localization/tree/hypothesis_set.hpp"

namespace opal {

/// Hears nothing; a test overrides what it wants to hear.
struct DeafListener : HypothesisListener {
  void spawned(const Live&, const Beginning&) override {}
  void ended(const Live&, const Ending&) override {}
  void associated(const Live&, std::span<const Association>) override {}
  void dissociated(const Live&, const std::vector<LocalFeatureId>&, const std::string&) override {}
  void branch_rejected(const Live&, const Association&, const std::string&) override {}
  void candidate_rejected(const VerifiedCandidate&, const std::string&) override {}
};

}  // namespace opal
