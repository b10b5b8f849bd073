#include "map/document/plain_objects.hpp"

#include "map/map_vocabulary.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

using nlohmann::json;
using namespace vocabulary;

/// Words that a JSON-LD processor leaves as they are: without a prefix, and no keyword.
const std::string& plain_id(const json& value) {
  if (!value.is_string()) throw NotPlain();
  const auto& id = value.get_ref<const std::string&>();
  if (id.empty() || id.front() == '@' || id.find(':') != std::string::npos) throw NotPlain();
  return id;
}

const std::string& plain_text(const json& value) {
  if (!value.is_string()) throw NotPlain();
  return value.get_ref<const std::string&>();
}

const std::string& plain_word(const json& value) {
  if (plain_text(value).empty()) throw NotPlain();
  return plain_text(value);
}

double plain_number(const json& value) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) throw NotPlain();
  return value.get<double>();
}

double plain_length(const json& value) {
  const double length_m = plain_number(value);
  if (length_m < 0) throw NotPlain();
  return length_m;
}

const json& entry(const json& node, const char* key) {
  const auto found = node.find(key);
  if (found == node.end()) throw NotPlain();
  return *found;
}

bool is_reference(const json& node) { return node.is_object() && node.size() == 1 && node.contains("@id"); }

/// The id of a node that is written elsewhere, or here as a word.
const std::string& plain_reference(const json& value) {
  if (value.is_string()) return plain_id(value);
  if (!is_reference(value)) throw NotPlain();
  return plain_id(value["@id"]);
}

void require_type(const json& node, const char* type) {
  if (!node.is_object() || entry(node, "@type") != type) throw NotPlain();
}

/// Calls with each node, or with the only one.
template <class Read>
void each_node(const json& value, Read read) {
  if (value.is_array() && value.empty()) throw NotPlain();
  if (!value.is_array()) return read(value);
  for (const json& node : value) read(node);
}

Segment plain_axis(const json& value) {
  if (!value.is_array() || value.size() != 4) throw NotPlain();
  return {{plain_number(value[0]), plain_number(value[1])}, {plain_number(value[2]), plain_number(value[3])}};
}

std::vector<std::string> plain_texts(const json& value) {
  if (!value.is_array()) throw NotPlain();
  std::vector<std::string> texts;
  for (const json& text : value) texts.push_back(plain_text(text));
  return texts;
}

/// @return false if the entry is no note.
bool read_note(const std::string& key, const json& value, ObjectNotes& notes) {
  if (key == "name")
    notes.name = plain_text(value);
  else if (key == "source_class")
    notes.source_class = plain_text(value);
  else if (key == "storey")
    notes.storey = plain_text(value);
  else if (key == "thickness_m")
    notes.thickness_m = plain_length(value);
  else if (key == "width_m")
    notes.width_m = plain_length(value);
  else if (key == "axis")
    notes.axis = plain_axis(value);
  else if (key == "merged_ids")
    notes.merged_ids = plain_texts(value);
  else
    return false;
  return true;
}

/// Entries beside those that a shape has.
bool read_quality(const std::string& key, const json& value, std::optional<double>& position_sigma_m,
                  std::optional<double>& existence) {
  if (key == "position_sigma_m") position_sigma_m = plain_number(value);
  if (key == "existence") existence = plain_number(value);
  return key == "position_sigma_m" || key == "existence";
}

bool is_sensor(const json& node) {
  const auto type = node.find("@type");
  return node.size() == 2 && node.contains("@id") && type != node.end() && *type == "Sensor";
}

bool is_object(const json& node) {
  if (node.contains("represented_by")) return true;
  const auto type = node.find("@type");
  if (type == node.end()) return false;
  if (!type->is_string()) throw NotPlain();
  return is_object_type(full_iri(type->get_ref<const std::string&>()));
}

}  // namespace

std::string_view PlainObjects::kept(const std::string& id) {
  char* copy = static_cast<char*>(memory_.allocate(id.size(), 1));
  std::copy(id.begin(), id.end(), copy);
  return {copy, id.size()};
}

bool PlainObjects::take(const json& node) {
  if (!node.is_object()) throw NotPlain();
  if (is_sensor(node)) return sensors_.insert(plain_id(node["@id"])).second;
  if (!is_object(node)) return false;
  read_object(node);
  return true;
}

void PlainObjects::read_object(const json& node) {
  MapObject object;
  object.id = plain_id(entry(node, "@id"));
  object.type = plain_word(entry(node, "@type"));
  if (is_reserved_type(full_iri(object.type))) throw NotPlain();
  const MapObjectNumber number(objects_.size());
  for (const auto& [key, value] : node.items()) {
    if (key == "@id" || key == "@type" || read_note(key, value, object.notes)) continue;
    if (key != "represented_by") throw NotPlain();
    each_node(value, [&](const json& representation) { read_representation(representation, number); });
  }
  objects_.push_back(std::move(object));
}

void PlainObjects::read_representation(const json& node, MapObjectNumber object) {
  require_type(node, "ObjectFeatureRepresentation");
  MapFeature feature;
  feature.object = object;
  const json* geometry = nullptr;
  std::optional<double> position_sigma_m, existence;
  for (const auto& [key, value] : node.items()) {
    if (key == "@id")
      feature.representation = plain_id(value);
    else if (key == "perceivable_by")
      feature.sensor = plain_reference(value);
    else if (key == "feature_type")
      feature.type = plain_word(value);
    else if (key == "represented_by")
      geometry = &value;
    else if (key != "@type" && !read_quality(key, value, position_sigma_m, existence))
      throw NotPlain();
  }
  if (geometry == nullptr) throw NotPlain();
  if (!feature.representation.empty() && !representations_.insert(kept(feature.representation)).second)
    throw NotPlain();
  if (!feature.sensor.empty()) perceiving_sensors_.insert(feature.sensor);
  feature.position_sigma_m = position_sigma_m.value_or(feature.position_sigma_m);
  feature.existence = existence.value_or(feature.existence);
  each_node(*geometry, [&](const json& one) { read_geometry(one, feature); });
}

void PlainObjects::read_geometry(const json& node, MapFeature feature) {
  const MapFeatureNumber number(features_.size());
  feature.id = plain_id(node.is_string() ? node : entry(node, "@id"));
  if (node.is_string() || is_reference(node)) {
    without_geometry_.push_back(number);
    features_.push_back(std::move(feature));
    return;
  }
  Definition definition{number, {}, {}};
  std::size_t others = 0;
  for (const auto& [key, value] : node.items())
    if (!read_quality(key, value, definition.position_sigma_m, definition.existence)) ++others;
  feature.position_sigma_m = definition.position_sigma_m.value_or(feature.position_sigma_m);
  feature.existence = definition.existence.value_or(feature.existence);
  feature.geometry = read_shape(node, feature);
  const std::size_t of_shape = std::holds_alternative<OrientedPoint>(feature.geometry) ? 5 : 4;
  if (others != of_shape || !geometries_.try_emplace(kept(feature.id), definition).second) throw NotPlain();
  features_.push_back(std::move(feature));
}

Geometry PlainObjects::read_shape(const json& node, MapFeature& feature) {
  const std::string& type = plain_text(entry(node, "@type"));
  if (type == "LineSegment") {
    const Point begin = read_point(entry(node, "begin"), "begin", feature);
    return Segment{begin, read_point(entry(node, "end"), "end", feature)};
  }
  if (type == "Corner") {
    const Point position = read_point(entry(node, "point"), "point", feature);
    return OrientedPoint{position, plain_number(entry(node, "heading_rad")), plain_number(entry(node, "opening_rad"))};
  }
  if (type == "Circle") {
    const Point center = read_point(entry(node, "center"), "center", feature);
    return Circle{center, plain_number(entry(node, "radius_m"))};
  }
  if (type != "Point") throw NotPlain();
  const Point position(plain_number(entry(node, "x")), plain_number(entry(node, "y")));
  feature.points = {feature.id};
  define_point(feature.id, position);
  return position;
}

/// @param role  what the point is to the feature, of which a point without a name gets its own.
Point PlainObjects::read_point(const json& node, const char* role, MapFeature& feature) {
  if (node.is_string() || is_reference(node)) {
    mentioned_points_.push_back({MapFeatureNumber(features_.size()), feature.points.size()});
    feature.points.push_back(plain_reference(node));
    return Point::Zero();
  }
  require_type(node, "Point");
  const bool has_name = node.contains("@id");
  if (node.size() != (has_name ? 4 : 3)) throw NotPlain();
  const Point position(plain_number(entry(node, "x")), plain_number(entry(node, "y")));
  feature.points.push_back(has_name ? plain_id(node["@id"]) : feature.id + "/" + role);
  if (has_name) define_point(feature.points.back(), position);
  return position;
}

void PlainObjects::define_point(const std::string& id, const Point& position) {
  if (!(position.cwiseAbs().maxCoeff() <= kFarthest_m)) throw NotPlain();
  if (!points_.try_emplace(kept(id), position).second) throw NotPlain();
}

/// What several sensors perceive is written in full once.
void PlainObjects::copy_geometries() {
  for (const MapFeatureNumber number : without_geometry_) {
    MapFeature& feature = features_[number.number()];
    const auto found = geometries_.find(feature.id);
    if (found == geometries_.end()) throw NotPlain();
    const MapFeature& first = features_[found->second.feature.number()];
    feature.geometry = first.geometry;
    feature.points = first.points;
    feature.position_sigma_m = found->second.position_sigma_m.value_or(feature.position_sigma_m);
    feature.existence = found->second.existence.value_or(feature.existence);
  }
}

void PlainObjects::place_points() {
  for (const Mention& mention : mentioned_points_) {
    MapFeature& feature = features_[mention.feature.number()];
    const auto found = points_.find(feature.points[mention.point]);
    if (found == points_.end()) throw NotPlain();
    *points_of(feature.geometry)[mention.point] = found->second;
  }
  for (const MapFeature& feature : features_)
    if (const auto* segment = std::get_if<Segment>(&feature.geometry);
        segment != nullptr && segment->length_m() <= kRounding_m)
      throw NotPlain();
}

void PlainObjects::finish(MapDraft& draft) {
  place_points();
  copy_geometries();
  draft.object_places.resize(objects_.size());
  draft.feature_places.resize(features_.size());
  draft.objects = std::move(objects_);
  draft.features = std::move(features_);
}

bool PlainObjects::defines_any(const std::unordered_set<std::string>& ids) const {
  const auto is_meant = [&ids](const auto& named) { return ids.contains(named.id); };
  const auto any_of = [&ids](const auto& names) {
    return std::any_of(ids.begin(), ids.end(), [&names](const std::string& id) { return names.contains(id); });
  };
  return std::any_of(objects_.begin(), objects_.end(), is_meant) || any_of(geometries_) || any_of(points_) ||
         any_of(representations_) || any_of(sensors_) || any_of(perceiving_sensors_);
}

bool PlainObjects::sensors_are_used() const {
  return std::all_of(sensors_.begin(), sensors_.end(),
                     [this](const std::string& sensor) { return perceiving_sensors_.contains(sensor); });
}

}  // namespace opal
