#pragma once

#include <opal/common/geometry.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace opal {

class SemanticMap;

/// A building of which a map holds storeys.
struct MapBuilding {
  std::string id;         ///< IRI or local name; unique in the map
  std::string name = {};  ///< for people; empty: the id
};

/// A storey of a map that holds several: a sheet. Sheets lie side by side in the map frame, so far apart that nothing
/// reaches from one to another. What lies on a storey is named "ID/...".
struct MapStorey {
  std::string id;                      ///< IRI or local name; unique in the map
  std::string name = {};               ///< for people; empty: the id
  std::string building = {};           ///< id of a MapBuilding; empty: not said
  std::optional<double> level_m = {};  ///< of its floor, in the building's coordinates; none: not said
  Point origin = Point::Zero();        ///< where the storey's own frame begins in the map; the axes are the map's
  std::array<Point, 2> bounds{Point::Zero(), Point::Zero()};  ///< of all on it, min and max, frame `map`; from `make`

  /// In the storey's own frame, in which its source was drawn.
  Pose2 to_storey(const Pose2& T_map) const {
    return {T_map.x() - origin.x(), T_map.y() - origin.y(), T_map.heading_rad()};
  }
  /// In the map frame.
  Pose2 to_map(const Pose2& T_storey) const {
    return {T_storey.x() + origin.x(), T_storey.y() + origin.y(), T_storey.heading_rad()};
  }
  /// What to call it: the name, or else the id.
  const std::string& label() const { return name.empty() ? id : name; }
};

/// Where a connection opens on one storey.
struct Landing {
  std::string storey;      ///< id of a MapStorey; empty in a map without storeys
  Pose2 T_storey_landing;  ///< its middle, in the storey's own frame; headings tell how storeys are turned
};

/// A way from storey to storey: a lift or stairs.
struct MapConnection {
  std::string id;                      ///< IRI or local name; unique in the map
  std::string type;                    ///< open: "opal:Lift", "opal:Stair"
  std::string name = {};               ///< for people; empty: the id
  double radius_m = 0;                 ///< of the cabin or the stairwell about each landing
  std::vector<Landing> landings = {};  ///< one per storey, in order of the storeys' ids
};

/// Where a pose lies in a map that holds storeys.
struct PlaceInBuilding {
  std::string building;  ///< id of the building; empty: not said
  std::string storey;    ///< id of the storey; empty: the map holds no storeys
  Pose2 T_storey_base;   ///< in the storey's own frame; in the map frame if there are no storeys
};

/// Sheets are apart at least by this: no beam, pattern or search reaches so far.
inline constexpr double kLeastSheetGap_m = 100;

/// The storey on whose sheet a point of the map lies, which is the nearest; null if the map holds no storeys.
OPAL_EXPORT const MapStorey* storey_at(const SemanticMap& map, const Point& p_map);
/// The storey with an id; null if there is none.
OPAL_EXPORT const MapStorey* find_storey(const SemanticMap& map, const std::string& id);
/// Building, storey and pose in the storey's frame.
OPAL_EXPORT PlaceInBuilding place_in_building(const SemanticMap& map, const Pose2& T_map_base);
/// "Third floor of GDC"; empty if the map holds no storeys.
OPAL_EXPORT std::string words_for(const SemanticMap& map, const PlaceInBuilding& place);
/// A landing in the map frame. Its storey exists, as `SemanticMap::make` has checked.
OPAL_EXPORT Pose2 landing_on_map(const SemanticMap& map, const Landing& landing);

}  // namespace opal
