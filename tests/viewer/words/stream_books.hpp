#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <string>

opal::Pose2 pose_of(const nlohmann::ordered_json& json);
opal::Geometry geometry_of(const nlohmann::ordered_json& json);

/// Books kept from events alone, in another way than the explainer keeps them.
struct StreamBooks {
  void take(const nlohmann::ordered_json& event);

  std::map<std::string, nlohmann::ordered_json> mapped;  ///< features by id
  std::map<std::string, std::string> types;              ///< of objects
  nlohmann::ordered_json objects;
  std::map<int, std::set<std::pair<int, std::string>>> pairs;    ///< by hypothesis; "": not on the map
  std::map<int, nlohmann::ordered_json> local, spawned, pruned;  ///< by id, the latter two with "time"
  std::map<int, std::pair<double, double>> highest;              ///< probability of a hypothesis, and when
  nlohmann::ordered_json keyframe, estimate, searched;           ///< the newest
  double first_s = 0, status_since_s = 0, searched_s = 0, now_s = 0;

 private:
  void add_pairs(const nlohmann::ordered_json& event);
  void take_estimate(const nlohmann::ordered_json& event);
};
