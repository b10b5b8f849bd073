#include "learning/drive_evidence.hpp"

#include <opal/common/error.hpp>

#include <array>

namespace opal {
namespace {

constexpr int kFormat = 1;
constexpr std::array kVerdicts{DeviationVerdict::as_mapped, DeviationVerdict::moved, DeviationVerdict::probably_absent};

nlohmann::ordered_json to_json(const Deviation& deviation) {
  return {{"object", deviation.object},
          {"type", deviation.type},
          {"verdict", name_of(deviation.verdict)},
          {"moved_x_m", deviation.moved.x()},
          {"moved_y_m", deviation.moved.y()},
          {"offset_m", deviation.offset_m},
          {"sigma_m", deviation.sigma_m},
          {"observations", deviation.observations},
          {"seen_through_share", deviation.seen_through_share}};
}

nlohmann::ordered_json to_json(const UnmappedFace& unmapped) {
  const Segment& face = unmapped.face;
  return {{"begin_x_m", face.begin.x()}, {"begin_y_m", face.begin.y()},
          {"end_x_m", face.end.x()},     {"end_y_m", face.end.y()},
          {"views", unmapped.views},     {"seen_through_share", unmapped.seen_through_share}};
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
  deviation.moved = {json.at("moved_x_m").get<double>(), json.at("moved_y_m").get<double>()};
  deviation.offset_m = json.at("offset_m");
  deviation.sigma_m = json.at("sigma_m");
  deviation.observations = json.at("observations");
  deviation.seen_through_share = json.at("seen_through_share");
  return deviation;
}

UnmappedFace face_from(const nlohmann::json& json) {
  return {{{json.at("begin_x_m").get<double>(), json.at("begin_y_m").get<double>()},
           {json.at("end_x_m").get<double>(), json.at("end_y_m").get<double>()}},
          json.at("views"),
          json.at("seen_through_share")};
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
    DriveEvidence evidence{
        document.at("map"), document.at("drive"), {}, document.at("learned_m"), document.at("left_out_m")};
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
