#include "map/semantic_map_storeys.hpp"

#include "common/geometry_box.hpp"
#include "common/phrases.hpp"
#include "map/map_vocabulary.hpp"

#include <algorithm>
#include <set>

namespace opal {
namespace {

using namespace vocabulary;

double gap_m(const std::array<Point, 2>& a, const std::array<Point, 2>& b) {
  return (a[0] - b[1]).cwiseMax(b[0] - a[1]).cwiseMax(Point::Zero()).norm();
}

std::string expected_storey(const std::vector<MapStorey>& storeys) {
  return storeys.empty() ? "no storey, for the map holds none" : "one of " + ids_of(storeys);
}

void measure(MapDraft& draft, MapStorey& storey) {
  const std::string prefix = storey.id + "/";
  Eigen::AlignedBox2d box;
  for (const MapFeature& feature : draft.features)
    if (feature.id.starts_with(prefix)) box.extend(box_of(feature.geometry));
  storey.bounds = {box.min(), box.max()};
  if (box.isEmpty())
    draft.fail("storey '" + storey.id + "'",
               "nothing lies on it, expected features whose ids begin with '" + prefix + "'");
}

void check_apart(const MapDraft& draft) {
  const std::vector<MapStorey>& storeys = draft.origin.storeys;
  for (std::size_t a = 0; a < storeys.size(); ++a)
    for (std::size_t b = a + 1; b < storeys.size(); ++b)
      if (const double gap = gap_m(storeys[a].bounds, storeys[b].bounds); gap < kLeastSheetGap_m)
        draft.fail("storey '" + storeys[b].id + "'",
                   "its sheet is " + opal::text_of(gap) + " m from that of '" + storeys[a].id +
                       "', expected at least " + opal::text_of(kLeastSheetGap_m) + " m; opal map stack places them");
}

/// Additions of an overlay need no prefix: they lie where some storey is.
void check_all_on_storeys(const MapDraft& draft) {
  const std::vector<MapStorey>& storeys = draft.origin.storeys;
  for (std::size_t i = 0; i < draft.features.size() && !storeys.empty(); ++i)
    for (const Point& p : points_of(draft.features[i].geometry)) {
      const auto near_enough = [&](const MapStorey& s) {
        return distance_to_box_m(s.bounds, p) < kLeastSheetGap_m / 4;
      };
      if (std::none_of(storeys.begin(), storeys.end(), near_enough))
        draft.fail(draft.feature_places[i], "feature '" + draft.features[i].id +
                                                "' lies on no storey, expected it within 25 m of what a storey holds");
    }
}

void check_connection(const MapDraft& draft, const MapConnection& connection) {
  const std::string place = "connection '" + connection.id + "'";
  if (!(connection.radius_m > 0 && connection.radius_m <= 100))
    draft.fail(place,
               "radius_m " + opal::text_of(connection.radius_m) + ", expected a positive number of metres up to 100");
  std::set<std::string> met;
  for (const Landing& landing : connection.landings) {
    const std::vector<MapStorey>& storeys = draft.origin.storeys;
    const bool is_known = storeys.empty() ? landing.storey.empty() : with_id(storeys, landing.storey) != nullptr;
    if (!is_known)
      draft.fail(place, "a landing on storey '" + landing.storey + "', expected " + expected_storey(storeys));
    if (!met.insert(landing.storey).second)
      draft.fail(place, "two landings on storey '" + landing.storey + "', expected one on each");
    const Pose2& T = landing.T_storey_landing;
    if (!(T.position().cwiseAbs().maxCoeff() <= kFarthest_m) || !std::isfinite(T.heading_rad()))
      draft.fail(place, "a landing that is not at a place, expected metres in the storey's frame, at most 1e6");
  }
}

void check_building(const MapDraft& draft, const MapStorey& storey) {
  if (!storey.building.empty() && with_id(draft.origin.buildings, storey.building) == nullptr)
    draft.fail("storey '" + storey.id + "'", "building '" + storey.building + "', expected one that the map names");
}

}  // namespace

std::string ids_of(const std::vector<MapStorey>& storeys) {
  std::vector<std::string> ids;
  for (const MapStorey& storey : storeys) ids.push_back(in_quotes(storey.id));
  return listed(ids);
}

void name_storeys(MapDraft& draft) {
  const auto compact = [&draft](std::string& name) { name = compact_name(name, draft.prefixes); };
  for (MapBuilding& building : draft.origin.buildings) compact(building.id);
  for (MapStorey& storey : draft.origin.storeys) {
    compact(storey.id);
    compact(storey.building);
  }
  for (MapConnection& connection : draft.origin.connections) {
    compact(connection.id);
    connection.type = compact_name(full_iri(connection.type), draft.prefixes);
    for (Landing& landing : connection.landings) compact(landing.storey);
  }
}

void sort_storeys(MapOrigin& origin) {
  const auto by_id = [](const auto& a, const auto& b) { return id_before(a.id, b.id); };
  std::stable_sort(origin.buildings.begin(), origin.buildings.end(), by_id);
  std::stable_sort(origin.storeys.begin(), origin.storeys.end(), by_id);
  std::stable_sort(origin.connections.begin(), origin.connections.end(), by_id);
  for (MapConnection& connection : origin.connections)
    std::stable_sort(connection.landings.begin(), connection.landings.end(),
                     [](const Landing& a, const Landing& b) { return id_before(a.storey, b.storey); });
}

void check_storeys(MapDraft& draft) {
  for (MapStorey& storey : draft.origin.storeys) {
    measure(draft, storey);
    check_building(draft, storey);
  }
  check_apart(draft);
  check_all_on_storeys(draft);
  for (const MapConnection& connection : draft.origin.connections) check_connection(draft, connection);
}

}  // namespace opal
