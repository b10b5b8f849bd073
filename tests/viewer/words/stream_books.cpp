#include "stream_books.hpp"

using namespace opal;
using nlohmann::ordered_json;

Pose2 pose_of(const ordered_json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Geometry geometry_of(const ordered_json& json) {
  const auto numbers = [&](const char* name) { return json[name].get<std::vector<double>>(); };
  if (json.contains("point")) return Point(numbers("point")[0], numbers("point")[1]);
  if (json.contains("circle")) {
    const auto n = numbers("circle");
    return Circle{Point(n[0], n[1]), n[2]};
  }
  if (json.contains("segment")) {
    const auto n = numbers("segment");
    return Segment{Point(n[0], n[1]), Point(n[2], n[3])};
  }
  const auto n = numbers("oriented_point");
  return OrientedPoint{Point(n[0], n[1]), n[2], n[3]};
}

void StreamBooks::take(const ordered_json& e) {
  const std::string kind = e["event"];
  if (kind == "map") {
    objects = e["objects"];
    for (const auto& object : objects) types[object[0]] = object[1];
    for (const auto& feature : e["features"]) mapped[feature["id"]] = feature;
  } else if (kind == "keyframe") {
    if (keyframe.is_null()) first_s = e["stamp_s"];
    keyframe = e;
    now_s = e["stamp_s"].get<double>() - first_s;
  } else if (kind == "local_features") {
    for (const auto& changed : e["changed"]) local[changed["id"]] = changed;
    for (int id : e["gone"]) local.erase(id);
  } else if (kind == "spawned") {
    spawned[e["hypothesis"]] = e;
    spawned[e["hypothesis"]]["time"] = now_s;
    add_pairs(e);
  } else if (kind == "associated") {
    add_pairs(e);
  } else if (kind == "dissociated") {
    for (int id : e["local_features"])
      std::erase_if(pairs[e["hypothesis"]], [&](const auto& pair) { return pair.first == id; });
  } else if (kind == "pruned") {
    pruned[e["hypothesis"]] = e;
    pruned[e["hypothesis"]]["time"] = now_s;
  } else if (kind == "searched") {
    searched = e;
    searched_s = now_s;
  } else if (kind == "estimate") {
    take_estimate(e);
  }
}

void StreamBooks::add_pairs(const ordered_json& e) {
  for (const auto& pair : e["pairs"])
    pairs[e["hypothesis"]].emplace(pair[0], pair[1].is_null() ? "" : pair[1].get<std::string>());
}

void StreamBooks::take_estimate(const ordered_json& e) {
  if (estimate.is_null() || estimate["status"] != e["status"]) status_since_s = now_s;
  estimate = e;
  for (const auto& row : e["hypotheses"]) {
    auto& [probability, when_s] = highest[row["hypothesis"]];
    if (row["probability"].get<double>() >= probability) probability = row["probability"], when_s = now_s;
  }
}
