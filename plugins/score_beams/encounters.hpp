#pragma once

#include "face_ends.hpp"

#include <opal/localization/scoring/scorer_memory.hpp>

#include <memory>
#include <vector>

/// Amounts by the number of a mapped thing, in order of number.
class Amounts {
 public:
  struct Entry {
    int thing = -1;
    double amount = 0;
  };
  /// 0 for a thing that was never added.
  double of(int thing) const;
  void add(int thing, double amount);
  /// All amounts times `keep`; what has nearly vanished is forgotten.
  void fade(double keep);
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// What the beams have met so far if a hypothesis is right. Seeing the same wall again is hardly new evidence: the
/// scorer counts what is not in here yet. In beams of a hundred where nothing else is said, summed over whole pieces of
/// evidence.
struct Encounters final : opal::ScorerMemory {
  Amounts cells_met;       ///< by evidence cell of the local map: beams that ended there, on a mapped surface
  Amounts lines_met;       ///< by Surface::line: beams that ended there
  Amounts ends_met;        ///< by FaceEnd::number: how often it was seen, each time by how near
  Amounts lines_ended;     ///< by Surface::line: ends of its faces that were seen, each by what its sightings are worth
  Amounts objects_met;     ///< by object: beams that ended there
  Amounts objects_passed;  ///< by object: beams that passed through it

  std::shared_ptr<const FaceEnds> face_ends;  ///< of the map; null in what one scan adds

  std::unique_ptr<opal::ScorerMemory> copy() const override { return std::make_unique<Encounters>(*this); }
  void fade(double keep);
  void add(const Encounters& newer, double weight);
};
