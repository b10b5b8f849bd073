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

/// Rules for tags of OpenStreetMap's simple indoor tagging, for IMDF, and for plain words.
std::map<std::string, std::string> default_classes();

}  // namespace opal::geojson_importer
