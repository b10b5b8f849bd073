#pragma once

#include <opal/map/semantic_map.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace opal {

/// What shall hold for one thing of a map, instead of what the map says. Metres and radians in the `map` frame.
struct OverlayChange {
  std::string target;              ///< id of an object, a representation, a geometry or a point
  std::string place;               ///< where it is written: "hall.overlay.jsonld: /@graph/0/changes/2"
  std::string because;             ///< in words; may be empty
  bool report_if_missing = false;  ///< a map without the target is no error
  /// New values: "x", "y" of a point, or of a geometry with one point; "heading_rad", "opening_rad" of a corner,
  /// "radius_m" of a circle; "existence", "position_sigma_m" of a geometry or of all that represent an object.
  std::map<std::string, double> numbers = {};
  std::map<std::string, double> was = {};         ///< what the map said when the change was written, by the same names
  std::map<std::string, std::string> types = {};  ///< "object_type", "feature_type"
  std::vector<std::string> perceivable_by = {};   ///< sensors that shall look for it
  std::vector<std::string> not_perceivable_by = {};  ///< sensors that shall not
};

/// A document that changes a map and adds to it, by id, and leaves the map as it was imported; docs/overlays.md.
struct MapOverlay {
  std::string source;  ///< file or name, first word of every message
  std::string name;    ///< for people; may be empty
  std::vector<OverlayChange> changes;
  nlohmann::json additions = nlohmann::json::array();  ///< all other nodes of the document, expanded and flattened
  std::map<std::string, std::string> prefixes = {};
};

/// Reads an overlay document strictly. What is added is checked when it meets the map, whose points it may use.
/// @throws MapError naming file, JSON pointer, what was found and what was expected.
OPAL_EXPORT MapOverlay read_overlay(const std::string& path);
/// @param name  stands for the file in messages.
OPAL_EXPORT MapOverlay parse_overlay(const std::string& text, const std::string& name);

struct OverlayOptions {
  bool report_missing = false;  ///< as if every change said so
};

struct OverlaidMap {
  std::shared_ptr<const SemanticMap> map;
  std::vector<std::string> changes;  ///< a sentence for each thing that was changed or added, in order of id
  std::vector<std::string> doubts;   ///< a sentence for each that does not fit the map (any more), in order of id
};

/// The map with all overlays, which are one set of changes: their order means nothing, and applying them to the result
/// again changes nothing. Points are moved for all that use them, and corners turn with the faces that meet in them.
/// Patterns lose dimensions that no longer hold, and are left out if a member is no longer perceivable.
/// @throws MapError for changes that contradict each other (naming both places), that mean nothing for their target, or
/// whose target the map does not have (naming all of them); for additions that are no map, or that the map has
/// otherwise.
OPAL_EXPORT OverlaidMap overlaid_map(const SemanticMap& map, const std::vector<MapOverlay>& overlays,
                                     const OverlayOptions& options = {});

}  // namespace opal
