#pragma once

#include "map/overlay/map_overlay.hpp"

#include "map/semantic_map_draft.hpp"

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace opal {

/// A map that overlays are being laid over. Objects and features of the map stand first, in its order. Numbers are
/// positions in `objects` and `features`.
///
/// What an overlay adds and the map has already stands here a second time, as a twin: changes are made to both, and in
/// the end they must be the same. So an overlay may change what another one adds, and be applied again.
struct OverlayDraft {
  struct Place {
    MapFeatureNumber feature = {};
    int point;  ///< position in its points
  };

  struct ObjectTwin {
    MapObject object;
    std::string place;  ///< "FILE: /@graph/3"
  };
  struct FeatureTwin {
    MapFeatureNumber original = {};  ///< what it must equal
    std::string place;
  };

  std::vector<MapObject> objects;
  std::vector<MapFeature> features;
  std::vector<ObjectTwin> object_twins;
  std::map<MapFeatureNumber, FeatureTwin> feature_twins;

  std::unordered_map<std::string, MapObjectNumber> objects_by_id;
  std::unordered_map<std::string, std::vector<MapFeatureNumber>> features_by_id, features_by_representation;
  std::unordered_map<MapObjectNumber, std::vector<MapFeatureNumber>> features_by_object;
  std::unordered_map<std::string, std::vector<Place>> features_by_point;

  explicit OverlayDraft(const SemanticMap& map);
  MapObjectNumber add(MapObject object);
  MapFeatureNumber add(MapFeature feature);
  MapObject& object(MapObjectNumber number) { return objects[number.number()]; }
  MapFeature& feature(MapFeatureNumber number) { return features[number.number()]; }
  const MapFeature& feature(MapFeatureNumber number) const { return features[number.number()]; }
  bool is_twin(MapFeatureNumber feature) const { return feature_twins.contains(feature); }

  /// Takes out the twins, and of several features with one id and sensor all but the first.
  /// @return for each position in `features` the new number; none: gone.
  /// @throws MapError if a twin differs from what it must equal.
  std::vector<MapFeatureNumber> settle();
};

/// Adds the objects and features of an overlay. @return what other vocabularies say there.
nlohmann::json add_to(OverlayDraft& draft, const MapOverlay& overlay, std::vector<std::string>& added);

/// Makes the changes of all overlays. @throws MapError.
class ChangeMaker {
 public:
  ChangeMaker(OverlayDraft& draft, const OverlayOptions& options) : draft_(draft), options_(options) {}
  void make(const std::vector<MapOverlay>& overlays);

  std::vector<std::string> sentences, doubts;
  std::set<std::string> set_corners;  ///< ids of corners whose direction a change says

 private:
  struct Target;
  using Found = std::vector<std::pair<const OverlayChange*, Target>>;
  struct Claim {
    std::string value, place;
  };

  bool find(const OverlayChange& change, Target& target) const;
  void check(const OverlayChange& change, const Target& target);
  void claim(const std::string& what, const std::string& value, const std::string& place);
  void check_was(const OverlayChange& change, const Target& target);
  void apply(const Found& found);
  std::string set_number(const Target& target, const std::string& word, double value);
  std::string set_type(const Target& target, const std::string& word, const std::string& type);
  std::string disable(const OverlayChange& change, const Target& target, const std::string& sensor);
  std::string enable(const Target& target, const std::string& sensor);
  std::vector<double> values_of(const Target& target, const std::string& word) const;
  std::vector<double*> numbers_of(const Target& target, const std::string& word) const;

  OverlayDraft& draft_;
  const OverlayOptions& options_;
  std::map<std::string, Claim> claims_;
};

/// Corners whose faces have turned turn with them, if they fitted them before. @param before  the draft before changes.
void turn_corners(const std::vector<MapFeature>& before, const std::set<std::string>& set_corners, OverlayDraft& draft,
                  std::vector<std::string>& sentences, std::vector<std::string>& doubts);

/// The map's patterns with the features that they have now; `numbers` has the new number of
/// each; none: it is gone.
std::vector<MapPattern> adapted_patterns(const SemanticMap& map, const std::vector<MapFeature>& features,
                                         const std::vector<MapFeatureNumber>& numbers,
                                         std::vector<std::string>& sentences);

}  // namespace opal
