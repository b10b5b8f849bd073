#pragma once

#include "face_ends.hpp"

#include <opal/local_map/local_map_ids.hpp>
#include <opal/localization/scoring/scorer_memory.hpp>
#include <opal/map/map_numbers.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace opal::score_beams {

/// Amounts by things of a kind, in the order of their numbers.
template <class Thing>
class AmountsBy {
 public:
  struct Entry {
    Thing thing;
    double amount = 0;
  };
  /// 0 for a thing that was never added.
  double of(Thing thing) const {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), thing, comes_before);
    return at != entries_.end() && at->thing == thing ? at->amount : 0;
  }
  void add(Thing thing, double amount) {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), thing, comes_before);
    if (at != entries_.end() && at->thing == thing)
      at->amount += amount;
    else
      entries_.insert(at, {thing, amount});
  }
  /// All amounts times `keep`; what has nearly vanished is forgotten.
  void fade(double keep) {
    constexpr double kNothing = 0.01;
    for (Entry& entry : entries_) entry.amount *= keep;
    std::erase_if(entries_, [](const Entry& entry) { return entry.amount < kNothing; });
  }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  static bool comes_before(const Entry& entry, Thing thing) { return entry.thing < thing; }

  std::vector<Entry> entries_;
};

/// What the beams have met so far if a hypothesis is right. Seeing the same wall again is hardly new evidence: the
/// scorer counts what is not in here yet. In beams of a hundred where nothing else is said, summed over whole pieces of
/// evidence.
struct Encounters final : ScorerMemory {
  AmountsBy<EvidenceCell> cells_met;       ///< beams that ended there, on a mapped surface
  AmountsBy<WallLineNumber> lines_met;     ///< beams that ended there
  AmountsBy<FaceEndNumber> ends_met;       ///< how often it was seen, each time by how near
  AmountsBy<WallLineNumber> lines_ended;   ///< ends of its faces that were seen, each by what its sightings are worth
  AmountsBy<MapObjectNumber> objects_met;  ///< beams that ended there
  AmountsBy<MapObjectNumber> objects_passed;  ///< beams that passed through it

  std::shared_ptr<const FaceEnds> face_ends;  ///< of the map; null in what one scan adds

  std::unique_ptr<ScorerMemory> copy() const override { return std::make_unique<Encounters>(*this); }
  void fade(double keep);
  void add(const Encounters& newer, double weight);
};

}  // namespace opal::score_beams
