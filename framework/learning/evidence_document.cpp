#include "learning/drive_evidence.hpp"

#include <opal/common/error.hpp>

#include <array>

namespace opal {
namespace {

constexpr int kFormat = 1;
constexpr std::array kVerdicts{DeviationVerdict::as_mapped, DeviationVerdict::moved, DeviationVerdict::probably_absent};

nlohmann::ordered_json to_json(const Deviation& deviation) {
  nlohmann::ordered_json faces = nlohmann::ordered_json::array();
  for (const FaceOffset& face : deviation.faces)
    faces.push_back({{"face", face.face}, {"offset_m", face.offset_m}, {"sigma_m", face.sigma_m}});
  return {{"object", deviation.object},
          {"type", deviation.type},
          {"verdict", name_of(deviation.verdict)},
          {"moved_x_m", deviation.moved.x()},
          {"moved_y_m", deviation.moved.y()},
          {"offset_m", deviation.offset_m},
          {"sigma_m", deviation.sigma_m},
          {"observations", deviation.observations},
          {"looks", deviation.looks},
          {"seen_through_share", deviation.seen_through_share},
          {"faces", std::move(faces)}};
}

nlohmann::ordered_json to_json(const UnmappedFace& unmapped) {
  const Segment& face = unmapped.face;
  return {{"begin_x_m", face.begin.x()}, {"begin_y_m", face.begin.y()},
          {"end_x_m", face.end.x()},     {"end_y_m", face.end.y()},
          {"views", unmapped.views},     {"seen_through_share", unmapped.seen_through_share}};
}

/// What is beyond is no place of a building and no number of keyframes.
constexpr double kFarthest_m = 1e6;
constexpr int kMostKeyframes = 1'000'000'000;

/// A number in [low, high].
double number_at(const nlohmann::json& json, const char* key, double low, double high) {
  const double value = json.at(key).get<double>();
  if (value >= low && value <= high) return value;
  throw ConfigError(std::string(key) + " " + json.at(key).dump() + ", expected " + nlohmann::json(low).dump() + " to " +
                    nlohmann::json(high).dump());
}
double metres_at(const nlohmann::json& json, const char* key) {
  return number_at(json, key, -kFarthest_m, kFarthest_m);
}
int count_at(const nlohmann::json& json, const char* key) {
  return static_cast<int>(number_at(json, key, 0, kMostKeyframes));
}

DeviationVerdict verdict_from(const std::string& word) {
  for (const DeviationVerdict verdict : kVerdicts)
    if (word == name_of(verdict)) return verdict;
  throw ConfigError("verdict \"" + word + "\", expected one of: as mapped, moved, probably absent");
}

Deviation deviation_from(const nlohmann::json& json) {
  Deviation deviation;
  deviation.object = json.at("object");
  deviation.type = json.at("type");
  deviation.verdict = verdict_from(json.at("verdict"));
  deviation.moved = {metres_at(json, "moved_x_m"), metres_at(json, "moved_y_m")};
  deviation.offset_m = metres_at(json, "offset_m");
  deviation.sigma_m = number_at(json, "sigma_m", 0, kFarthest_m);
  deviation.observations = count_at(json, "observations");
  // Evidence of earlier versions does not tell it.
  deviation.looks = json.contains("looks") ? number_at(json, "looks", 0, kMostKeyframes) : deviation.observations;
  deviation.seen_through_share = number_at(json, "seen_through_share", 0, 1);
  if (json.contains("faces"))
    for (const nlohmann::json& face : json.at("faces"))
      deviation.faces.push_back(
          {face.at("face"), metres_at(face, "offset_m"), number_at(face, "sigma_m", 0, kFarthest_m)});
  return deviation;
}

UnmappedFace face_from(const nlohmann::json& json) {
  return {{{metres_at(json, "begin_x_m"), metres_at(json, "begin_y_m")},
           {metres_at(json, "end_x_m"), metres_at(json, "end_y_m")}},
          count_at(json, "views"),
          number_at(json, "seen_through_share", 0, 1)};
}

}  // namespace

nlohmann::ordered_json to_json(const DriveEvidence& evidence) {
  nlohmann::ordered_json visits = nlohmann::ordered_json::array();
  for (const VisitEvidence& visit : evidence.visits) {
    nlohmann::ordered_json objects = nlohmann::ordered_json::array(), unmapped = nlohmann::ordered_json::array();
    for (const Deviation& deviation : visit.objects) objects.push_back(to_json(deviation));
    for (const UnmappedFace& face : visit.unmapped) unmapped.push_back(to_json(face));
    visits.push_back({{"objects", std::move(objects)}, {"unmapped", std::move(unmapped)}});
  }
  return {{"opal_evidence", kFormat},          {"map", evidence.map},
          {"drive", evidence.drive},           {"learned_m", evidence.learned_m},
          {"left_out_m", evidence.left_out_m}, {"visits", std::move(visits)}};
}

DriveEvidence drive_evidence_from(const nlohmann::json& document, const std::string& file) {
  try {
    if (document.at("opal_evidence") != kFormat)
      throw ConfigError("format " + document.at("opal_evidence").dump() + ", expected " + std::to_string(kFormat));
    DriveEvidence evidence{document.at("map"),
                           document.at("drive"),
                           {},
                           number_at(document, "learned_m", 0, kFarthest_m),
                           number_at(document, "left_out_m", 0, kFarthest_m)};
    for (const nlohmann::json& visit : document.at("visits")) {
      evidence.visits.emplace_back();
      for (const nlohmann::json& object : visit.at("objects"))
        evidence.visits.back().objects.push_back(deviation_from(object));
      for (const nlohmann::json& face : visit.at("unmapped"))
        evidence.visits.back().unmapped.push_back(face_from(face));
    }
    return evidence;
  } catch (const nlohmann::json::exception& error) {
    throw ConfigError(file + ": is no evidence of a drive: " + error.what());
  } catch (const ConfigError& error) {
    throw ConfigError(file + ": " + error.what());
  }
}

}  // namespace opal
