#include "types_by_words.hpp"

#include "feature_classes.hpp"
#include "part_words.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace opal::geojson_importer {
namespace {

// Fewer rooms show no habit.
constexpr int kFewestAlike = 3;
// Of areas that are held against each other; a plan of one building has a thousand.
constexpr std::size_t kMostPairs = 4'000'000;

/// What is damaged is left as it is: words are no reason to refuse a file.
bool may_be_known(const Feature& feature) { return feature.type.empty() && feature.damage.empty(); }

bool is_area_of(const Feature& feature) { return feature.type == kRoom || feature.type == kCorridor; }

bool is_inside(const Point& p, const Ring& ring) {
  bool inside = false;
  for (std::size_t k = 0, before = ring.size() - 1; k < ring.size(); before = k++) {
    const Point &a = ring[before], &b = ring[k];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

Point middle_of(const Ring& ring) {
  Point sum = Point::Zero();
  for (const Point& p : ring) sum += p;
  return sum / static_cast<double>(ring.size());
}

struct Middle {
  Point point;
  const Feature* feature = nullptr;
};

bool are_on_one_level(const Feature& a, const Feature& b) {
  return a.levels.empty() || b.levels.empty() || std::ranges::any_of(a.levels, [&](const std::string& level) {
           return std::ranges::find(b.levels, level) != b.levels.end();
         });
}

/// Whether the middle of any other area on its level lies in a feature.
bool is_around_any(const Feature& feature, const std::vector<Middle>& middles) {
  return std::ranges::any_of(middles, [&](const Middle& middle) {
    return are_on_one_level(feature, *middle.feature) &&
           std::ranges::any_of(feature.shapes.polygons,
                               [&](const auto& polygon) { return is_inside(middle.point, polygon.front()); });
  });
}

/// "USE_TYPE" of "USE_TYPE=Office".
std::string key_of(const std::string& said) { return said.substr(0, said.find('=')); }

bool has_text_at(const Feature& feature, const std::string& key) {
  const auto found = feature.properties.find(key);
  return !feature.shapes.polygons.empty() && found != feature.properties.end() && found->is_string() &&
         !found->get_ref<const std::string&>().empty();
}

/// Beside walls of the plan's own, areas by words are none.
void take_words(FeatureCollection& collection) {
  std::vector<Feature*> areas;
  for (Feature& feature : collection.features) {
    const auto known = may_be_known(feature) ? class_by_words(feature) : std::nullopt;
    if (!known) continue;
    std::tie(feature.type, feature.said_by) = *known;
    if (is_area_of(feature)) areas.push_back(&feature);
  }
  const bool has_walls =
      std::ranges::any_of(collection.features, [](const Feature& feature) { return feature.type == "opal:Wall"; });
  for (Feature* area : areas)
    if (has_walls) area->type = area->said_by = "";
}

/// The property by words of which most areas are known; empty: none.
std::string usual_key(const FeatureCollection& collection) {
  std::map<std::string, int> known;
  for (const Feature& feature : collection.features)
    if (is_area_of(feature) && !feature.said_by.empty()) ++known[key_of(feature.said_by)];
  const auto most = std::ranges::max_element(known, [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == known.end() || most->second < kFewestAlike || !is_kind_key(most->first)) return "";
  const auto all = std::ranges::count_if(collection.features,
                                         [&](const Feature& feature) { return has_text_at(feature, most->first); });
  return 2 * most->second >= all ? most->first : "";
}

void take_others_of_usual_key(FeatureCollection& collection) {
  const std::string key = usual_key(collection);
  if (key.empty()) return;
  std::vector<Middle> middles;
  std::vector<Feature*> others;
  for (Feature& feature : collection.features) {
    if (is_area_of(feature))
      for (const auto& polygon : feature.shapes.polygons) middles.push_back({middle_of(polygon.front()), &feature});
    if (may_be_known(feature) && has_text_at(feature, key)) others.push_back(&feature);
  }
  if (middles.size() * others.size() > kMostPairs) return;
  for (Feature* other : others) {
    if (is_around_any(*other, middles)) continue;
    other->type = kCorridor;
    other->said_by = key + "=" + other->properties.at(key).get<std::string>();
  }
}

void take_name(const std::string& file, FeatureCollection& collection) {
  if (std::ranges::any_of(collection.features, [](const Feature& feature) { return !feature.type.empty(); })) return;
  const std::string& name = collection.name.empty() ? file : collection.name;
  const auto type = class_by_name(name);
  if (!type) return;
  for (Feature& feature : collection.features)
    if (may_be_known(feature)) feature.type = *type;
  collection.notes.push_back("every feature taken for " + *type + ", as the collection is called '" + name + "'");
}

}  // namespace

void find_types_by_words(const std::string& file, FeatureCollection& collection) {
  take_words(collection);
  take_others_of_usual_key(collection);
  take_name(file, collection);
}

}  // namespace opal::geojson_importer
