#pragma once

#include <opal/localization/observation/observation.hpp>
#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/map/view/map_view.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace opal {

/// Compares places that look alike, two at a time, by the beams that tell them apart: those that the map lets end
/// elsewhere at one of the two. What two storeys or two equal rooms have in common says nothing about which one is
/// right. Scorers sum it up all the same, and with it the small errors of map and pose.
///
/// A beam passes through the surface that the map has there, ends before it or ends on it (three outcomes of a beam
/// model; Thrun, Burgard and Fox, Probabilistic Robotics, 2005, section 6.3). How likely each outcome is at a right
/// place is read off the beams that both places expect alike. With n(o) for a place's beams of outcome o on an evidence
/// cell, in beams of a hundred summed over whole pieces of evidence, the first place of a pair leads by
///
///   nat = share * sum over evidence cells of  sum over o of (n_first(o) - n_second(o)) log p(o)  /  (n + 1)
///
/// Places that have less in common are left to the scorers: there an error of the map is no exception among the
/// beams that differ.
class OPAL_EXPORT PlaceComparison {
 public:
  /// @param places  so many of the best places are compared with each other; fewer than 2: none.
  /// @param memory  share of what was seen that is kept per whole piece of evidence.
  PlaceComparison(std::shared_ptr<const MapView> map, int places, double memory)
      : map_(std::move(map)), most_places_(static_cast<std::size_t>(std::max(0, places))), memory_(memory) {}

  /// A place where the robot may be.
  struct Place {
    HypothesisId hypothesis;
    Pose2 T_map_base;
  };
  /// What was seen at one time.
  struct Sight {
    std::span<const ObservedScan> scans;
    double weight = 0;              ///< how much of a new piece of evidence it is, in (0, 1]
    std::span<const Place> places;  ///< where the robot was then
  };
  /// Compares the best places by what is seen now.
  /// @param seen  with the places of all hypotheses that are alive, best first.
  void add(const Sight& seen);

  /// Compares the best places that were not compared with each other yet by what was seen before: who comes late has
  /// to explain that, too.
  /// @param before  oldest first; where a hypothesis has no place then, it explains nothing.
  /// @param places  of all hypotheses that are alive, best first.
  void look_back(std::span<const Sight> before, std::span<const Place> places);

  /// By how much another place explains better what tells the two apart [nat], >= 0: the most of all comparisons.
  double against_nat(HypothesisId hypothesis) const;

  void clear() { pairs_.clear(); }

 private:
  enum class Outcome { passes, ends_before, ends_on };
  using Outcomes = std::array<double, 3>;  ///< beams of a hundred, summed over whole pieces of evidence
  struct Telling {
    Outcomes first{}, second{};  ///< what the same beams are at the two places
  };
  struct Expected {
    double range_m = 0;  ///< to the surface
    Outcome outcome = Outcome::ends_before;
  };
  struct Pair {
    HypothesisId first, second;  ///< in this order
    Outcomes common{};           ///< of beams that do not tell the two apart
    std::map<EvidenceCell, Telling> telling{};
    double lead_nat = 0;  ///< nat() after the newest observation: each of the two asks

    double nat() const;  ///< by which the first one leads
    void fade(double kept);
    void add(const Expected& at_first, const Expected& at_second, EvidenceCell cell, double beams);
  };

  Expected expect(const Point& eye, const Point& end) const;
  void add_scan(const ObservedScan& scan, std::span<const Place> places, double weight);
  void add_scans(const Sight& seen, std::span<const Place> places);
  void look_back(std::span<const Sight> before, HypothesisId one, HypothesisId other);
  std::span<const Place> best_of(std::span<const Place> places) const;
  Pair* find(HypothesisId one, HypothesisId other);
  Pair& pair_of(HypothesisId one, HypothesisId other);
  void forget_all_but(std::span<const Place> places);

  std::shared_ptr<const MapView> map_;
  std::size_t most_places_;
  double memory_;
  std::vector<Pair> pairs_;
};

}  // namespace opal
