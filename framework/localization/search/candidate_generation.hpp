#pragma once

#include "localization/search/coarse_to_fine.hpp"
#include "map/view/support_lines.hpp"

#include <opal/common/named.hpp>
#include <opal/localization/options/localizer_options.hpp>
#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/patterns/pattern_template.hpp>
#include "patterns/pattern_index.hpp"

#include <span>
#include <vector>

namespace opal {

using TemplateNumber = Id<PatternTemplate>;  ///< position among the generator's templates

/// A feature that patterns may be made of, with the local feature that it belongs to.
struct SearchFeature {
  Feature feature;  ///< base_link frame
  LocalFeatureId local = {};
};

/// A pose at which an observed pattern would be a mapped one.
struct Candidate {
  Pose2 T_map_base;
  TemplateNumber pattern = {};  ///< that proposed it; none: a hint did
  std::vector<Association> pairs = {};
};

/// Looks observed patterns up among mapped ones. Built once per map.
class OPAL_EXPORT CandidateGenerator {
 public:
  CandidateGenerator(std::shared_ptr<const MapView> map, std::vector<Named<PatternTemplate>> templates,
                     const SearchOptions& options);

  /// @param coarse  a few dozen scan points, base_link, by which candidates are filtered.
  /// @param under_constrained   look up patterns with a free parameter (true), or those that fix the pose (false).
  /// What was looked up, for the event stream.
  struct LookedUp {
    TemplateNumber pattern = {};
    std::vector<LocalFeatureId> local_features;
    std::size_t expected = 0;  ///< places that the index predicts
  };
  struct Proposal {
    std::vector<Candidate> candidates;  ///< the best, one per place, nearest first
    std::vector<LookedUp> looked_up;
  };
  Proposal propose(std::span<const SearchFeature> features, std::span<const Point> coarse,
                   bool under_constrained) const;

  const std::string& pattern_name(TemplateNumber pattern) const { return table(pattern).name; }

 private:
  struct Table {
    std::string name;
    std::shared_ptr<const PatternTemplate> part;
    PatternIndex index;  ///< members are positions in mapped_
  };
  struct Lookup {
    TemplateNumber pattern = {};
    PatternInstance observed;
    std::size_t expected = 0;
  };
  struct Place {
    Point position;  ///< of base_link, map frame
    double heading_rad;
    double likelihood_field;
    int lookup;
    int mapped;
  };

  const Table& table(TemplateNumber pattern) const { return tables_[pattern.number()]; }
  const Table& table(const Lookup& lookup) const { return table(lookup.pattern); }
  std::vector<Lookup> shortlist(TemplateNumber pattern, std::span<const Feature> features,
                                bool under_constrained) const;
  /// Those that are expected least often, as long as they have no more places together; the fewest in any case.
  static void keep_rarest(std::vector<Lookup>& lookups, std::size_t most_places, std::size_t fewest,
                          bool under_constrained);
  static void leave_out_parts(std::vector<Lookup>& chosen);
  std::vector<Lookup> choose(std::span<const SearchFeature> best, bool under_constrained) const;
  /// Poses by a few points in large cells; where a pattern sweeps, every third one.
  void look_up(const Lookup& lookup, int number, const TellingPoints& points, BestShare& filter,
               std::vector<Place>& places) const;
  bool is_in_region(const Point& position) const;
  void sweep(const PatternInstance& observed, const PatternTable& table, int mapped, const Point& position,
             std::vector<Point>& positions) const;
  /// Likelihood-field score by all points. @param points  of each lookup.
  void look_closely(std::vector<Place>& places, std::vector<TellingPoints>& points, double slack_m) const;
  /// Each place, and those a step before and behind it along its sweep.
  std::vector<Place> with_neighbours(const std::vector<Place>& places, const std::vector<Lookup>& lookups) const;
  static bool nearer(const Place& a, const Place& b);
  static void keep_nearest(std::vector<Place>& places, std::size_t most);
  /// From many places seen hastily to a few seen closely.
  std::vector<Place> places_for(const std::vector<Lookup>& lookups, std::span<const Point> coarse,
                                bool under_constrained) const;
  std::vector<Association> pair_up(const Lookup& lookup, int mapped, const Pose2& T_map_base,
                                   std::span<const SearchFeature> features) const;

  std::shared_ptr<const MapView> map_;
  SearchOptions options_;
  std::vector<MappedFeature> mapped_;
  std::vector<Table> tables_;
};

/// The best candidates such that no two are within distance_m and angle_rad; at most `most`.
OPAL_EXPORT std::vector<std::size_t> distinct_places(std::span<const Pose2> poses_best_first, double distance_m,
                                                     double angle_rad, std::size_t most);

}  // namespace opal
