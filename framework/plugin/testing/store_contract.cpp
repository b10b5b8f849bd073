#include <opal/plugin/testing/store_contract.hpp>

#include "plugin/testing/scene.hpp"
#include "plugin/testing/violations.hpp"

#include <opal/map/view/map_view.hpp>
#include "map/check/map_diff.hpp"

#include <algorithm>
#include <cstdlib>

namespace opal::testing {
namespace {

constexpr const char* kSensor = "PlanarLidar2D";

/// @param suffix  makes a map that differs.
std::shared_ptr<const SemanticMap> map_of_room(const std::string& suffix) {
  std::vector<MapFeature> features;
  for (const Geometry& geometry : example_room()) {
    MapFeature feature;
    feature.id = std::string("f").append(std::to_string(features.size() + 1)).append(suffix);
    feature.object = MapObjectNumber(0);
    feature.sensor = features.size() % 5 == 4 ? "Camera" : kSensor;
    feature.geometry = geometry;
    features.push_back(feature);
  }
  return SemanticMap::make("A room called 'it''s \"odd\"'; --", {{"room", "opal:Wall"}}, std::move(features));
}

/// Expects a call to throw `Expected`, and not only because the store cannot be reached.
template <class Expected, class Call>
void expect_refusal(Violations& violations, const std::string& what, Call&& call) {
  try {
    call();
    violations.add("accepts " + what, "accepts " + what + ", expected an error");
  } catch (const StoreUnreachable&) {
    violations.add("connects " + what, "connects before it refuses " + what);
  } catch (const Expected&) {
    return;
  } catch (const std::exception& error) {
    violations.add("kind " + what, "refuses " + what + " with an error of the wrong kind: " + error.what());
  }
}

std::vector<MapFeatureNumber> numbers_near(const MapStore& store, const NearQuery& query) {
  std::vector<MapFeatureNumber> numbers;
  for (const NearFeature& feature : store.features_near(query)) numbers.push_back(feature.number);
  return numbers;
}

void check_questions(Violations& violations, const MapStore& store, const std::shared_ptr<const SemanticMap>& map,
                     const std::string& building) {
  const MapView view(map, kSensor);
  for (int k = 0; k < 40; ++k) {
    const int column = k % 8, row = k / 8;
    const Point center(0.35 * column, 0.6 * row);
    std::vector<MapFeatureNumber> expected = view.within(center, 0.25 * (k % 6));
    std::sort(expected.begin(), expected.end());
    if (numbers_near(store, {building, 1, kSensor, center, 0.25 * (k % 6)}) != expected)
      violations.add("near", "finds other features near a point than a MapView does");
  }
}

void check_versions(Violations& violations, const MapStore& store, const std::string& building) {
  const auto first = map_of_room(""), second = map_of_room("b");
  const StoredVersion one = store.push(*first, {building, "first"});
  const StoredVersion two = store.push(*second, {building, "second", 1});
  if (one.version != 1 || two.version != 2) violations.add("numbers", "does not number versions 1, 2");
  expect_refusal<StoreConflict>(violations, "a push that expects another version", [&] {
    store.push(*first, {building, "", 1});
  });
  if (store.list(building).size() != 2) violations.add("list", "does not list the versions that were pushed");
  const auto pulled = [&](int version) { return SemanticMap::parse(store.pull(building, version).document, "pulled"); };
  if (!map_diff(*first, *pulled(1)).empty() || !map_diff(*second, *pulled(2)).empty())
    violations.add("round trip", "gives back another map than was pushed");
  if (!map_diff(*second, *pulled(0)).empty())
    violations.add("newest", "does not give the newest version for version 0");
  expect_refusal<StoreError>(violations, "a version that is not there", [&] { store.pull(building, 3); });
  check_questions(violations, store, first, building);
}

}  // namespace

std::vector<std::string> map_store_violations(const MapStore& store, const TypeInfo& type) {
  Violations violations(type.name);
  violations.expect_no_throw("saying where it is", [&] {
    const std::string where = store.where();
    if (where.empty()) violations.add("where", "does not say where it is");
    const char* password = std::getenv("PGPASSWORD");
    if (password != nullptr && *password != '\0' && where.find(password) != std::string::npos)
      violations.add("secret", "tells a password when it says where it is");
  });
  expect_refusal<StoreError>(violations, "a push for a building without a name", [&] {
    store.push(*map_of_room(""), {"", ""});
  });
  expect_refusal<StoreError>(violations, "a pull for a building without a name", [&] { store.pull("", 0); });
  expect_refusal<StoreError>(violations, "a negative version", [&] { store.pull("hall", -1); });
  expect_refusal<StoreError>(violations, "a radius below zero", [&] {
    store.features_near({"hall", 0, kSensor, Point::Zero(), -1});
  });
  return violations.take();
}

std::vector<std::string> live_map_store_violations(const MapStore& store, const TypeInfo& type,
                                                   const std::string& building) {
  Violations violations(type.name);
  if (!store.list(building).empty()) {
    violations.add("new", "has versions of the building '" + building + "' already, expected a new one");
    return violations.take();
  }
  expect_refusal<StoreError>(violations, "a pull of a building that is not there", [&] { store.pull(building, 0); });
  violations.expect_no_throw("pushing and pulling", [&] { check_versions(violations, store, building); });
  return violations.take();
}

}  // namespace opal::testing
