#pragma once

#include <opal/map/semantic_map.hpp>
#include <opal/sensing/feature_detector.hpp>

#include <functional>
#include <span>
#include <string>

namespace opal {

/// How a detector looks at a mapped building.
struct DerivationOptions {
  std::string sensor = "PlanarLidar2D";  ///< id of the sensor that perceives the features
  double spacing_m = 0.8;                ///< between neighbouring places to look from
  double reach_m = 10;                   ///< of the laser
  bool doors_open = false;               ///< leaves are out of the way; false: shut
  double clearance_m = 0.25;             ///< from a place to look from to the nearest surface, at least
  int fewest_views = 5;                  ///< a feature is found from so many places, at least
  double least_share = 0.15;             ///< ... and from this share of the places that have it in view
  /// Is told what share of the places has been looked from; may be empty.
  std::function<void(double)> progress = {};
};

/// A map with the features that a detector finds on its objects.
struct Derivation {
  std::shared_ptr<const SemanticMap> map;  ///< what it had, and the features that are new
  std::vector<std::string> added;          ///< ids of the new features, in order
  std::size_t places = 0;                  ///< looked from
  std::size_t known = 0;                   ///< found features that the map has already
  std::size_t twice = 0;                   ///< found features that are another view of a new one
  std::size_t seldom = 0;                  ///< found from too few places
  std::size_t on_nothing = 0;              ///< found where no mapped object is
};

/// Lets a detector look at clean scans of a building without furniture from places all over its floor, and
/// gives each thing that it finds again and again to the mapped object where it stands. The same map and detector give
/// the same answer.
/// @param map       frame `map`.
/// @param detector  anything but features of `types` that it finds is left out.
/// @param types     feature types: those that the detector produces.
/// @param prefixes  IRIs of the prefixes in `types`; one that is neither here nor in the map gets an IRI of its own.
/// @throws MapError if nobody can stand anywhere in the building.
Derivation derived_features(const SemanticMap& map, const FeatureDetector& detector, std::span<const std::string> types,
                            const DerivationOptions& options = {},
                            const std::map<std::string, std::string>& prefixes = {});

}  // namespace opal
