#include <opal/localization/scoring/scorer_memory.hpp>

namespace opal {

ScorerMemory::~ScorerMemory() = default;

ScorerMemory* ScorerMemories::own(std::size_t scorer) {
  if (scorer >= memories_.size() || !memories_[scorer]) return nullptr;
  Shared& memory = memories_[scorer];
  if (memory.use_count() > 1) memory = memory->copy();
  return memory.get();
}

}  // namespace opal
