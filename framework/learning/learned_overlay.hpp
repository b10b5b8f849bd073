#pragma once

#include "learning/drive_evidence.hpp"

#include <opal/map/semantic_map.hpp>

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace opal {

enum class Change { moved, gone, added };
const char* name_of(Change change);

/// What one visit saw of what a proposal is about.
struct VisitSight {
  std::string drive;
  bool agrees = false;                                     ///< with the proposal
  int keyframes = 0;                                       ///< that saw it
  DeviationVerdict verdict = DeviationVerdict::as_mapped;  ///< of an object on the map
  Point moved = Point::Zero();                             ///< of a moved object: from where the map says [m]
  double sigma_m = 0;                                      ///< one-sigma of `moved`
  Segment face = {};                                       ///< of something added
  double seen_through_share = 0;                           ///< of its looks: through it, in [0, 1]
};

/// A difference between the building and its map that drives agree on, or do not.
struct Proposal {
  std::string id;    ///< of the object; of something added "learned-1", ...
  std::string type;  ///< of the object
  Change change = Change::moved;
  double probability = 0;       ///< that it is so
  bool is_conflicting = false;  ///< visits say different things; never part of the overlay
  bool moves_about = false;     ///< it was there on one visit and not on another; never part of the overlay
  Point moved = Point::Zero();  ///< from where the map says [m], frame `map`
  double sigma_m = 0;           ///< one-sigma of `moved`, per axis
  /// Of its faces that were recognized, by id: from where the map says, along the normal [m].
  std::map<std::string, double> face_offsets = {};
  Segment face = {};  ///< of something added
  int visits_for = 0, visits_against = 0;
  std::vector<std::string> drives = {};  ///< that say so, in order
  std::vector<VisitSight> sights = {};   ///< of each visit, in order of the drives
};

/// Changes that are less probable are usually told, and not made.
inline constexpr double kLeastProbability = 0.9;

/// The object of a map that a proposal is about; null for something added.
const MapObject* object_of(const SemanticMap& map, const Proposal& proposal);

/// What many drives say together.
struct Learned {
  std::vector<Proposal> proposals;  ///< most probable first, then by id
  std::size_t sound = 0;            ///< objects that stand where the map says, as far as drives tell
  std::size_t unseen = 0;           ///< objects that no drive tells anything of
};

/// Puts the evidence of drives together. Visits are independent; within a visit beams are not, so a visit counts once,
/// the more the more keyframes it has. The same set of drives gives the same answer, whatever their order; a drive that
/// comes twice counts once.
Learned learned_from(const SemanticMap& map, std::span<const DriveEvidence> drives);

/// The overlay of all proposals that are as probable and not in conflict (docs/overlays.md), as a JSON-LD document.
/// @param sensor  that perceives what is added, and does not perceive any more what is gone.
nlohmann::ordered_json overlay_of(const SemanticMap& map, const Learned& learned, const std::string& sensor,
                                  double least_probability);

/// The overlay of those among all proposals that a person or a rule chooses. What is in conflict is never part of it.
/// @param is_chosen  gets proposals of `learned` themselves, not copies.
nlohmann::ordered_json overlay_of(const SemanticMap& map, const Learned& learned, const std::string& sensor,
                                  const std::function<bool(const Proposal&)>& is_chosen);

/// Where the overlay of these proposals puts points of the map, by id [m], frame `map`; those that stay are left out.
std::map<std::string, Point> moved_points(const SemanticMap& map, std::span<const Proposal> proposals);

/// Why a proposal cannot be part of an overlay; empty: it can.
std::string objection_to(const Proposal& proposal);

/// What was seen, how often, and by which drives, in a sentence.
std::string sentence_of(const Proposal& proposal);
/// What one visit saw of it.
std::string sentence_of(const Proposal& proposal, const VisitSight& sight);

}  // namespace opal
