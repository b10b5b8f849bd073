#pragma once

#include <opal/localization/localizer.hpp>

#include <map>
#include <string>
#include <vector>

namespace opal::benchmark {

/// An association of the best hypothesis, by name and by geometry (map frame).
struct NamedAssociation {
  opal::LocalFeatureId local_feature = {};
  std::string object, feature;  ///< the object in words, the feature's id
  opal::Geometry local, mapped;
  double off_m = 0;  ///< of the local geometry from the mapped one
};

/// What the best hypothesis rests on; features that are not on the map are left out.
std::vector<NamedAssociation> associations_of(const opal::Localizer& localizer);

std::string pose_words(const opal::Pose2& pose);
/// The same with storey and building, in the storey's own frame first, where the map holds storeys.
std::string place_words(const opal::Localizer& localizer, const opal::Pose2& T_map_base);

/// A line for each plugin that threw, by its type's name; empty: none did.
std::string skipped_text(const std::map<std::string, int>& plugin_failures);

/// Status, pose, alternatives and associations, on stdout.
/// @param why  the status is what it is.
void print_answer(const opal::Localizer& localizer, const opal::PoseEstimate& answer, const std::string& why);

}  // namespace opal::benchmark
