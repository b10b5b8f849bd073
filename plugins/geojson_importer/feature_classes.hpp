#pragma once

#include "geojson_reader.hpp"

#include <map>
#include <string>
#include <vector>

namespace opal::geojson_importer {

/// By what names rules may know a feature.
struct FeatureClasses {
  std::vector<std::string>
      names;          ///< "indoor=wall", one for each property; or the value of the one property that is asked for
  std::string shown;  ///< the one that says most, for the report
};

/// @param class_property  name of the property that holds the class; empty: all may say it.
FeatureClasses classes_of(const Feature& feature, const std::string& class_property);

/// What parts of a floor become: not things by themselves, but the walls around them.
inline constexpr const char* kRoom = "opal:Room";          ///< walls on all sides
inline constexpr const char* kCorridor = "opal:Corridor";  ///< walls, but not towards corridors and open areas
inline constexpr const char* kArea = "opal:Area";          ///< no walls of its own
/// An opening without a leaf: walls are cut there.
inline constexpr const char* kOpening = "opal:Opening";

/// Rules for tags of OpenStreetMap's simple indoor tagging, for IMDF, and for plain words.
std::map<std::string, std::string> default_classes();

}  // namespace opal::geojson_importer
