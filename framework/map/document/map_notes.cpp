#include "map/document/map_notes.hpp"

#include "map/map_vocabulary.hpp"

namespace opal {
namespace {

using namespace vocabulary;
using Json = nlohmann::ordered_json;

/// Lengths that say nothing if they are 0.
double length_of(const GraphNode& node, std::string_view iri) {
  const double length_m = node.number(iri).value_or(0);
  if (length_m < 0) node.fail(short_term(iri) + " of " + node.description() + " is below 0, expected a length");
  return length_m;
}

std::optional<Segment> axis_of(const GraphNode& node) {
  const std::vector<double> ends = node.number_list(iri::kAxis);
  if (ends.empty()) return std::nullopt;
  if (ends.size() != 4)
    node.fail("axis of " + node.description() + " has " + std::to_string(ends.size()) +
              " numbers, expected 4: x, y of both ends");
  return Segment{{ends[0], ends[1]}, {ends[2], ends[3]}};
}

void write_text(Json& node, const char* term, const std::string& text) {
  if (!text.empty()) node[term] = text;
}

void write_length(Json& node, const char* term, double length_m) {
  if (length_m != 0) node[term] = length_m;
}

}  // namespace

bool ObjectNotes::operator==(const ObjectNotes& other) const {
  const auto same_axis = [&] {
    if (!axis || !other.axis) return axis.has_value() == other.axis.has_value();
    return axis->begin == other.axis->begin && axis->end == other.axis->end;
  };
  return name == other.name && source_class == other.source_class && storey == other.storey &&
         thickness_m == other.thickness_m && width_m == other.width_m && merged_ids == other.merged_ids && same_axis();
}

ObjectNotes read_object_notes(const GraphNode& node) {
  ObjectNotes notes;
  notes.name = node.text(iri::kName).value_or("");
  notes.source_class = node.text(iri::kSourceClass).value_or("");
  notes.storey = node.text(iri::kStorey).value_or("");
  notes.thickness_m = length_of(node, iri::kThickness);
  notes.width_m = length_of(node, iri::kWidth);
  notes.axis = axis_of(node);
  notes.merged_ids = node.text_list(iri::kMergedIds);
  return notes;
}

void write_notes(const ObjectNotes& notes, Json& node) {
  write_text(node, "name", notes.name);
  write_text(node, "source_class", notes.source_class);
  write_text(node, "storey", notes.storey);
  write_length(node, "thickness_m", notes.thickness_m);
  write_length(node, "width_m", notes.width_m);
  if (notes.axis)
    node["axis"] = {notes.axis->begin.x(), notes.axis->begin.y(), notes.axis->end.x(), notes.axis->end.y()};
  if (!notes.merged_ids.empty()) node["merged_ids"] = notes.merged_ids;
}

void read_origin_notes(const GraphNode& node, MapOrigin& origin) {
  origin.cut_height_m = node.number(iri::kCutHeight);
  origin.storey = node.text(iri::kStorey).value_or("");
  origin.widest_door_m = length_of(node, iri::kWidestDoor);
  origin.north_rad = node.number(iri::kNorth);
  const std::optional<std::string> crs = node.text(iri::kCrs);
  for (const std::string_view word : {iri::kEastings, iri::kNorthings, iri::kCrsHeight, iri::kCrsHeading})
    if (node.has(word) && !crs)
      node.fail(node.description() + " has " + short_term(word) +
                " without crs, expected the name of the coordinate system");
  if (crs)
    origin.georeference = {*crs, node.required_number(iri::kEastings), node.required_number(iri::kNorthings),
                           node.number(iri::kCrsHeight).value_or(0), node.number(iri::kCrsHeading).value_or(0)};
}

void write_notes(const MapOrigin& origin, Json& node) {
  if (origin.cut_height_m) node["cut_height_m"] = *origin.cut_height_m;
  write_text(node, "storey", origin.storey);
  write_length(node, "widest_door_m", origin.widest_door_m);
  if (origin.north_rad) node["north_rad"] = *origin.north_rad;
  if (!origin.georeference) return;
  node["crs"] = origin.georeference->crs;
  node["eastings_m"] = origin.georeference->eastings_m;
  node["northings_m"] = origin.georeference->northings_m;
  node["crs_height_m"] = origin.georeference->height_m;
  node["crs_heading_rad"] = origin.georeference->heading_rad;
}

}  // namespace opal
