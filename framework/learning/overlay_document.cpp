#include "learning/learned_overlay.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <map>

namespace opal {
namespace {

using json = nlohmann::ordered_json;

double rounded(double value) { return std::round(1000 * value) / 1000; }

/// Where a point that several faces share goes: along the normal of each face by that face's displacement, and not
/// otherwise. Least squares.
struct PointShift {
  Point at = Point::Zero();
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Point pull = Point::Zero();
  std::string because;
  double share = 1;  ///< of the way that it goes

  void pull_by(const Eigen::Matrix2d& weight, const Point& moved) {
    information += weight;
    pull += weight * moved;
  }
  Point place() const {
    constexpr double kStay = 1e-3;  // directions that no face fixes
    return at + share * (information + kStay * Eigen::Matrix2d::Identity()).ldlt().solve(pull);
  }
};

using Shifts = std::map<std::string, PointShift>;

void shift(Shifts& shifts, const MapFeature& feature, const Point& moved, const std::string& because) {
  const auto at = [&](std::size_t k, const Point& p, const Eigen::Matrix2d& weight) {
    PointShift& point = shifts[feature.points[k]];
    point.at = p;
    point.pull_by(weight, moved);
    if (point.because.empty()) point.because = because;
  };
  if (const auto* face = std::get_if<Segment>(&feature.geometry)) {
    const Eigen::Matrix2d across = face->normal() * face->normal().transpose();
    at(0, face->begin, across);
    at(1, face->end, across);
  } else {
    at(0, anchor_of(feature.geometry), Eigen::Matrix2d::Identity());
  }
}

/// Maps are drawn to five centimetres: less is left as it is.
double clear_part(double offset_m) { return std::abs(offset_m) > 0.05 ? offset_m : 0; }

/// Whether two faces may be the two sides of one wall, or pieces of one side.
bool go_together(const Segment& a, const Segment& b) {
  constexpr double kParallel = 0.95, kThickest_m = 1;
  return std::abs(a.direction().dot(b.direction())) > kParallel &&
         std::abs(a.normal().dot(b.midpoint() - a.begin)) < kThickest_m;
}

/// Where a face was recognized, it goes there; another side of the same wall goes along.
Point moved_by(const SemanticMap& map, const MapObject& object, const Proposal& proposal, const MapFeature& feature) {
  const auto* face = std::get_if<Segment>(&feature.geometry);
  if (!face || proposal.face_offsets.empty()) return proposal.moved;
  if (const auto own = proposal.face_offsets.find(feature.id); own != proposal.face_offsets.end())
    return clear_part(own->second) * face->normal();
  for (const MapFeatureNumber number : object.features) {
    const MapFeature& other = map.feature(number);
    const auto seen = proposal.face_offsets.find(other.id);
    if (seen == proposal.face_offsets.end()) continue;
    const auto& side = std::get<Segment>(other.geometry);
    if (go_together(*face, side)) return clear_part(seen->second) * side.normal();
  }
  return Point::Zero();
}

/// What of a face is left where its points go, along its direction [m].
double length_left_m(const Segment& face, const PointShift* begin, const PointShift* end) {
  return face.direction().dot((end ? end->place() : face.end) - (begin ? begin->place() : face.begin));
}

/// The sides of a thin wall may be seen so far inwards that nothing of its end is left. Then its points go half the
/// way.
void keep_faces(const SemanticMap& map, Shifts& shifts) {
  constexpr double kLeast_m = 0.02;
  constexpr int kMostHalvings = 10;
  const auto shift_of = [&](const std::string& point) {
    const auto found = shifts.find(point);
    return found == shifts.end() ? nullptr : &found->second;
  };
  for (const MapFeature& feature : map.features()) {
    const auto* face = std::get_if<Segment>(&feature.geometry);
    if (!face || feature.points.size() != 2) continue;
    PointShift *begin = shift_of(feature.points[0]), *end = shift_of(feature.points[1]);
    const double least_m = std::min(kLeast_m, face->length_m() / 2);
    for (int k = 0; k < kMostHalvings && length_left_m(*face, begin, end) < least_m; ++k)
      for (PointShift* point : {begin, end})
        if (point) point->share /= 2;
  }
}

Shifts shifts_of(const SemanticMap& map, std::span<const Proposal> proposals) {
  Shifts shifts;
  for (const Proposal& proposal : proposals) {
    const MapObject* object = proposal.change == Change::moved ? object_of(map, proposal) : nullptr;
    if (!object) continue;
    for (const MapFeatureNumber number : object->features)
      shift(shifts, map.feature(number), moved_by(map, *object, proposal, map.feature(number)),
            object->id + " " + sentence_of(proposal));
  }
  keep_faces(map, shifts);
  return shifts;
}

json node_of(const Proposal& proposal, const std::string& sensor) {
  constexpr double kSigma_m = 0.1;  // as far as the pose from which it was seen follows what the map has wrong
  const auto point = [&](const char* end, const Point& p) -> json {
    return {{"@id", proposal.id + "/" + end}, {"@type", "Point"}, {"x", rounded(p.x())}, {"y", rounded(p.y())}};
  };
  return {{"@id", proposal.id},
          {"@type", "Wall"},
          {"represented_by",
           {{"@type", "ObjectFeatureRepresentation"},
            {"perceivable_by", sensor},
            {"represented_by",
             {{"@id", proposal.id + "/face"},
              {"@type", "LineSegment"},
              {"existence", rounded(proposal.probability)},
              {"position_sigma_m", kSigma_m},
              {"begin", point("begin", proposal.face.begin)},
              {"end", point("end", proposal.face.end)}}}}}};
}

}  // namespace

json overlay_of(const SemanticMap& map, const Learned& learned, const std::string& sensor,
                const std::function<bool(const Proposal&)>& is_chosen) {
  json changes = json::array(), graph = json::array(), added = json::array();
  std::vector<Proposal> chosen;
  for (const Proposal& proposal : learned.proposals)
    if (objection_to(proposal).empty() && is_chosen(proposal)) chosen.push_back(proposal);
  for (const Proposal& proposal : chosen) {
    if (proposal.change == Change::added) added.push_back(node_of(proposal, sensor));
    if (proposal.change == Change::gone)
      changes.push_back({{"target", proposal.id}, {"not_perceivable_by", sensor}, {"because", sentence_of(proposal)}});
  }
  for (const auto& [id, point] : shifts_of(map, chosen)) {
    const Point place = point.place();
    changes.push_back({{"target", id},
                       {"x", rounded(place.x())},
                       {"y", rounded(place.y())},
                       {"was", {{"x", point.at.x()}, {"y", point.at.y()}}},
                       {"because", point.because}});
  }
  graph.push_back({{"@type", "MapOverlay"}, {"name", "Learned while driving"}, {"changes", std::move(changes)}});
  for (json& node : added) graph.push_back(std::move(node));
  return {{"@context", "urn:opal:v1"}, {"@graph", std::move(graph)}};
}

json overlay_of(const SemanticMap& map, const Learned& learned, const std::string& sensor, double least_probability) {
  return overlay_of(map, learned, sensor,
                    [&](const Proposal& proposal) { return proposal.probability >= least_probability; });
}

std::map<std::string, Point> moved_points(const SemanticMap& map, std::span<const Proposal> proposals) {
  std::map<std::string, Point> points;
  for (const auto& [id, shift] : shifts_of(map, proposals)) points.emplace(id, shift.place());
  return points;
}

}  // namespace opal
