#include <opal/localization/scoring/scorer_memory.hpp>

namespace opal {

ScorerMemory::~ScorerMemory() = default;

ScorerMemory* ScorerMemories::own(std::size_t scorer) {
  if (scorer >= memories_.size() || !memories_[scorer]) return nullptr;
  Shared& memory = memories_[scorer];
  std::shared_ptr<ScorerMemory> mine(memory->copy());
  ScorerMemory* changeable = mine.get();
  memory = std::move(mine);
  return changeable;
}

}  // namespace opal
