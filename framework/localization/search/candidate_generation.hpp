#pragma once

#include "common/pose_tolerance.hpp"
#include "localization/search/candidate.hpp"
#include "localization/search/coarse_to_fine.hpp"
#include "localization/search/pattern_lookup.hpp"
#include "patterns/mapped_patterns.hpp"

#include <opal/common/named.hpp>
#include <opal/map/view/map_view.hpp>

#include <span>
#include <vector>

namespace opal {

/// A feature that patterns may be made of, with the local feature that it belongs to.
struct SearchFeature {
  Feature feature;  ///< base_link frame
  LocalFeatureId local = {};
};

/// Looks observed patterns up among mapped ones. Built once per map.
class OPAL_EXPORT CandidateGenerator {
 public:
  CandidateGenerator(std::shared_ptr<const MapView> map, std::vector<Named<PatternTemplate>> templates,
                     const SearchOptions& options);

  /// What a scan asks the map, and which of the places that answer have passed so far.
  class Inquiry;
  /// @param features  that patterns may be made of.
  /// @param coarse  a few dozen scan points, base_link, by which places are filtered.
  /// @param kind  of patterns to look up.
  Inquiry ask(std::span<const SearchFeature> features, std::span<const Point> coarse, PatternKind kind) const;
  /// Looks at further places of the map, each of them once: until there are no more, or `most` have been looked at.
  /// @return true if there are no more.
  bool look_up(Inquiry& inquiry, std::size_t most) const;

  /// What was looked up, for the event stream.
  struct LookedUp {
    TemplateNumber pattern = {};
    std::vector<LocalFeatureId> local_features;
    std::size_t expected = 0;  ///< mapped patterns that the index predicts
  };
  struct Proposal {
    std::vector<Candidate> candidates;  ///< the best, one per place, nearest first
    std::vector<LookedUp> looked_up;
  };
  /// @param inquiry  of which all places have been looked at.
  Proposal propose(Inquiry inquiry) const;

  const std::string& pattern_name(TemplateNumber pattern) const { return templates_[pattern.number()].name; }

 private:
  struct Place {
    Point position;  ///< of base_link, map frame
    double heading_rad;
    double likelihood_field;
    int lookup;
    int mapped;
  };

  const PatternIndex& index_of(const PatternLookup& lookup) const { return templates_[lookup.pattern.number()].index; }
  /// Poses by a few points in large cells; where a pattern sweeps, every third one.
  /// @return how many were looked at.
  std::size_t look_up_newest(Inquiry& inquiry, std::size_t most) const;
  void sweep(const PatternInstance& observed, const PatternTable& table, int mapped, const Point& position,
             std::vector<Point>& positions) const;
  /// Likelihood-field score by all points.
  void look_closely(std::vector<Place>& places, Inquiry& inquiry, double slack_m) const;
  /// Each place, and those a step before and behind it along its sweep.
  std::vector<Place> with_neighbours(const std::vector<Place>& places, const Inquiry& inquiry) const;
  static bool nearer(const Place& a, const Place& b);
  static void keep_nearest(std::vector<Place>& places, std::size_t most);
  /// From many places seen hastily to a few seen closely.
  std::vector<Place> nearest_places(Inquiry& inquiry) const;
  std::vector<Association> pair_up(const PatternLookup& lookup, int mapped, const Pose2& T_map_base,
                                   std::span<const SearchFeature> features) const;

  std::shared_ptr<const MapView> map_;
  SearchOptions options_;
  MemberNumbers members_;
  std::vector<MappedTemplate> templates_;
};

class CandidateGenerator::Inquiry {
 public:
  /// Whether no place of the map is looked at, because nothing is seen that could tell one.
  bool is_empty() const;

 private:
  friend CandidateGenerator;
  explicit Inquiry(std::size_t close_looks) : filter(close_looks, kOneInPasses) {}

  /// The best one of so many places passes: a search keeps a few hundred of some thousand.
  static constexpr std::size_t kOneInPasses = 30;

  PatternKind kind = PatternKind::constrained;
  std::vector<SearchFeature> features;  ///< the best ones
  std::vector<PatternLookup> lookups;
  std::vector<TellingPoints> points;  ///< of each lookup
  BestShare filter;
  std::vector<Place> places;  ///< that have passed

  std::size_t lookup = 0;  ///< the newest
  std::vector<int> found;  ///< by it
  std::size_t next = 0;    ///< of these, to be looked at
};

/// The best candidates such that no two are at one place; at most `most`.
OPAL_EXPORT std::vector<std::size_t> distinct_places(std::span<const Pose2> poses_best_first,
                                                     const PoseTolerance& apart, std::size_t most);

}  // namespace opal
