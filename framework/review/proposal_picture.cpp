#include "review/proposal_picture.hpp"

#include <cmath>
#include <set>

namespace opal {
namespace {

using nlohmann::ordered_json;

/// A page is looked at, not measured.
double plotted(double value) { return std::round(1000 * value) / 1000; }

/// The geometry with its points where they are now; others stay.
Geometry moved_geometry(const MapFeature& feature, const std::map<std::string, Point>& places) {
  const auto place = [&](std::size_t k, const Point& otherwise) {
    const auto found = k < feature.points.size() ? places.find(feature.points[k]) : places.end();
    return found == places.end() ? otherwise : found->second;
  };
  if (const auto* face = std::get_if<Segment>(&feature.geometry))
    return Segment{place(0, face->begin), place(1, face->end)};
  const Point before = anchor_of(feature.geometry);
  return transformed(Pose2(place(0, before) - before, 0), feature.geometry);
}

}  // namespace

ordered_json shapes_of(const std::vector<Geometry>& geometries) {
  ordered_json faces = ordered_json::array(), circles = ordered_json::array(), points = ordered_json::array();
  const auto add = [](ordered_json& list, std::initializer_list<double> numbers) {
    for (const double number : numbers) list.push_back(plotted(number));
  };
  for (const Geometry& geometry : geometries) {
    if (const auto* face = std::get_if<Segment>(&geometry))
      add(faces, {face->begin.x(), face->begin.y(), face->end.x(), face->end.y()});
    else if (const auto* circle = std::get_if<Circle>(&geometry))
      add(circles, {circle->center.x(), circle->center.y(), circle->radius_m});
    else
      add(points, {anchor_of(geometry).x(), anchor_of(geometry).y()});
  }
  return {{"faces", std::move(faces)}, {"circles", std::move(circles)}, {"points", std::move(points)}};
}

ProposalPictures::ProposalPictures(const SemanticMap& map) : map_(map) {
  std::set<std::string> known;
  for (std::size_t k = 0; k < map.features().size(); ++k) {
    const MapFeature& feature = map.features()[k];
    if (!known.insert(feature.id).second) continue;
    features_.push_back(k);
    for (const std::string& point : feature.points) at_point_[point].push_back(k);
    of_object_[map.object(feature.object).id].push_back(k);
  }
}

ordered_json ProposalPictures::whole_map() const {
  std::vector<Geometry> geometries;
  for (const std::size_t k : features_) geometries.push_back(map_.features()[k].geometry);
  return shapes_of(geometries);
}

std::vector<Geometry> ProposalPictures::mapped(const std::string& object) const {
  std::vector<Geometry> geometries;
  const auto features = of_object_.find(object);
  if (features == of_object_.end()) return geometries;
  for (const std::size_t k : features->second) geometries.push_back(map_.features()[k].geometry);
  return geometries;
}

std::vector<Geometry> ProposalPictures::proposed(const Proposal& proposal) const {
  if (proposal.change == Change::added) return {proposal.face};
  std::vector<Geometry> geometries;
  const std::map<std::string, Point> places = moved_points(map_, std::span(&proposal, 1));
  std::set<std::size_t> touched;
  for (const auto& [point, place] : places)
    if (const auto users = at_point_.find(point); users != at_point_.end())
      touched.insert(users->second.begin(), users->second.end());
  for (const std::size_t k : touched) geometries.push_back(moved_geometry(map_.features()[k], places));
  return geometries;
}

std::vector<Geometry> ProposalPictures::seen(const Proposal& proposal, const VisitSight& sight) const {
  if (proposal.change == Change::added) return {sight.face};
  if (sight.verdict == DeviationVerdict::probably_absent) return {};
  if (sight.verdict == DeviationVerdict::as_mapped) return mapped(proposal.id);
  std::vector<Geometry> geometries;
  for (const Geometry& geometry : mapped(proposal.id))
    geometries.push_back(transformed(Pose2(sight.moved, 0), geometry));
  return geometries;
}

ordered_json ProposalPictures::of(const Proposal& proposal) const {
  ordered_json sights = ordered_json::array();
  for (const VisitSight& sight : proposal.sights) sights.push_back(shapes_of(seen(proposal, sight)));
  return {{"mapped", shapes_of(mapped(proposal.id))},
          {"proposed", shapes_of(proposed(proposal))},
          {"sights", std::move(sights)}};
}

}  // namespace opal
