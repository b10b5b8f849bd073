#include "viewer/reading/run_header_events.hpp"

#include "map/semantic_map_storeys.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <unordered_set>

namespace opal {
namespace {

constexpr int kFormat = 3;

std::string optional_sentence(const EventPlace& event, const char* name) {
  const auto found = event.find(name);
  return found ? found->sentence() : "";
}

void find_shared_names(std::vector<RunHeader::Object>& objects) {
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const RunHeader::Object& object : objects) ++counts[{object.type, object.name}];
  for (RunHeader::Object& object : objects) object.name_is_shared = counts[{object.type, object.name}] > 1;
}

std::vector<RunHeader::Object> read_objects(const EventPlace& array) {
  std::vector<RunHeader::Object> objects(array.elements());
  std::unordered_set<std::string> ids;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const EventPlace object = array.element(k), id = object.element(0);
    if (!ids.insert(id.name()).second) id.fail("an id that no other object has");
    objects[k] = {id.name(), object.element(1).name()};
    if (object.elements() > 2) objects[k].name = object.element(2).sentence();
  }
  find_shared_names(objects);
  return objects;
}

RunHeader::Feature read_feature(const EventPlace& place, std::size_t objects) {
  RunHeader::Feature feature;
  feature.id = place.member("id").name();
  const EventPlace object = place.member("object");
  feature.object = object.id<MapObjectNumber>();
  if (feature.object >= MapObjectNumber(objects)) object.fail(fmt::format("one of {} objects", objects));
  feature.type = place.member("type").name();
  if (const auto perceivable = place.find("perceivable")) feature.perceivable = perceivable->flag();
  feature.geometry = place.geometry();
  return feature;
}

RunHeader::Pattern read_pattern(const EventPlace& place, const FeaturePositions& positions) {
  RunHeader::Pattern pattern{place.member("id").name(), place.member("template").name(), {}};
  const EventPlace members = place.member("features");
  for (std::size_t k = 0; k < members.elements(); ++k)
    pattern.features.push_back(mapped_feature(members.element(k), positions));
  return pattern;
}

RunHeader::Storey read_storey(const EventPlace& place) {
  const EventPlace origin = place.member("origin"), bounds = place.member("bounds");
  if (origin.elements() != 2) origin.fail("[x, y]");
  if (bounds.elements() != 4) bounds.fail("[least x, least y, most x, most y]");
  const auto point = [](const EventPlace& array, std::size_t k) {
    return Point(array.element(k).coordinate(), array.element(k + 1).coordinate());
  };
  return {place.member("id").name(),
          place.member("name").sentence(),
          point(origin, 0),
          {point(bounds, 0), point(bounds, 2)}};
}

}  // namespace

const RunHeader::Storey* RunHeader::storey_at(const Point& p) const { return nearest_sheet(storeys, p); }

MapFeatureNumber mapped_feature(const EventPlace& id, const FeaturePositions& positions) {
  const auto found = positions.find(id.name());
  if (found == positions.end()) id.fail("the id of a feature of the map event");
  return found->second;
}

void read_run_event(const EventPlace& event, RunHeader& header) {
  const EventPlace format = event.member("format");
  if (format.count() != kFormat) format.fail("3, the format of event streams that this version of Opal reads");
  header.opal = optional_sentence(event, "opal");
  header.log = optional_sentence(event, "log");
  header.config = optional_sentence(event, "config");
  header.map_file = optional_sentence(event, "map");
  header.sensor = optional_sentence(event, "sensor");
  if (const auto pose = event.find("T_base_laser")) header.T_base_laser = pose->pose();
  if (const auto range = event.find("range_max_m")) header.range_max_m = range->number(0, EventPlace::kFarthest_m);
}

FeaturePositions read_map_event(const EventPlace& event, RunHeader& header) {
  header.map_name = optional_sentence(event, "name");
  header.objects = read_objects(event.member("objects"));
  FeaturePositions positions;
  const EventPlace features = event.member("features");
  for (std::size_t k = 0; k < features.elements(); ++k) {
    const EventPlace place = features.element(k);
    header.features.push_back(read_feature(place, header.objects.size()));
    // One geometry may stand once per sensor; what this run's sensor perceives is what events mean.
    const auto [known, is_new] = positions.try_emplace(header.features.back().id, MapFeatureNumber(k));
    if (!is_new && !header.feature(known->second).perceivable) known->second = MapFeatureNumber(k);
  }
  if (const auto storeys = event.find("storeys"))
    for (std::size_t k = 0; k < storeys->elements(); ++k) header.storeys.push_back(read_storey(storeys->element(k)));
  if (const auto patterns = event.find("patterns"))
    for (std::size_t k = 0; k < patterns->elements(); ++k)
      header.patterns.push_back(read_pattern(patterns->element(k), positions));
  return positions;
}

std::vector<StampedPose> read_truth_event(const EventPlace& event) {
  const EventPlace array = event.member("poses");
  std::vector<StampedPose> poses(array.elements());
  double newest_s = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const EventPlace row = array.element(k);
    if (row.elements() != 4) row.fail("[stamp, x, y, heading]");
    const EventPlace stamp = row.element(0);
    if (!(stamp.stamp_s() > newest_s)) stamp.fail("a stamp after the one before");
    newest_s = stamp.stamp_s();
    poses[k] = {newest_s, {row.element(1).coordinate(), row.element(2).coordinate(), row.element(3).coordinate()}};
  }
  return poses;
}

}  // namespace opal
