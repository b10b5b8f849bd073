#pragma once

#include "map/semantic_map_draft.hpp"

#include <nlohmann/json.hpp>

#include <memory_resource>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace opal {

/// Something that only the general reader understands.
struct NotPlain {};

/// Reads things in the building, one node of a document's graph each, in the terms of Opal's context.
class PlainObjects {
 public:
  /// @return true: the node is a thing in the building or a sensor, and is read; false: it is something else.
  /// @throws NotPlain if it is such a thing, but not plainly written.
  bool take(const nlohmann::json& node);
  /// Moves objects and features into the draft; their types stay as they are written.
  /// @throws NotPlain if something refers to what no node defines.
  void finish(MapDraft& draft);
  /// True if one of the ids is that of something that was taken, or of a sensor that perceives it.
  bool defines_any(const std::unordered_set<std::string>& ids) const;
  /// True if every sensor that was taken perceives something.
  bool sensors_are_used() const;

 private:
  /// A geometry where it is written in full.
  struct Definition {
    MapFeatureNumber feature;  ///< the first that has it
    std::optional<double> position_sigma_m, existence;
  };
  /// A point of a feature that is written elsewhere.
  struct Mention {
    MapFeatureNumber feature;
    std::size_t point;
  };

  void read_object(const nlohmann::json& node);
  void read_representation(const nlohmann::json& node, MapObjectNumber object);
  void read_geometry(const nlohmann::json& node, MapFeature feature);
  Geometry read_shape(const nlohmann::json& node, MapFeature& feature);
  Point read_point(const nlohmann::json& node, const char* role, MapFeature& feature);
  void define_point(const std::string& id, const Point& position);
  void copy_geometries();
  void place_points();

  /// A copy that stays where it is.
  std::string_view kept(const std::string& id);

  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  std::pmr::monotonic_buffer_resource memory_;  ///< of what is known by its id: it goes away as one
  std::pmr::unordered_map<std::string_view, Definition> geometries_{&memory_};
  std::pmr::unordered_map<std::string_view, Point> points_{&memory_};
  std::pmr::unordered_set<std::string_view> representations_{&memory_};  ///< that have a name
  std::unordered_set<std::string> sensors_, perceiving_sensors_;
  std::vector<MapFeatureNumber> without_geometry_;  ///< it is written elsewhere
  std::vector<Mention> mentioned_points_;
};

}  // namespace opal
