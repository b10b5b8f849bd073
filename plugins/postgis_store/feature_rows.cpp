#include "feature_rows.hpp"

#include <opal/common/number_text.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace opal::postgis_store {
namespace {

using nlohmann::json;

/// What the shapes have of their own.
struct ShapeColumns {
  json operator()(const Point& p) const { return at("point", p); }
  json operator()(const OrientedPoint& corner) const {
    json row = at("corner", corner.position);
    row["heading_rad"] = corner.heading_rad;
    row["opening_rad"] = corner.opening_rad;
    return row;
  }
  json operator()(const Segment& segment) const {
    json row = at("segment", segment.begin);
    row["x2"] = segment.end.x();
    row["y2"] = segment.end.y();
    return row;
  }
  json operator()(const Circle& circle) const {
    json row = at("circle", circle.center);
    row["radius_m"] = circle.radius_m;
    return row;
  }

  static json at(const char* shape, const Point& p) {
    return {{"shape", shape}, {"x", p.x()}, {"y", p.y()}, {"radius_m", 0.0}};
  }
};

}  // namespace

const char* const kInsertFeatures =
    "INSERT INTO opal.features (map, number, id, sensor, type, object, object_type, representation, shape, geom, "
    "radius_m, "
    "heading_rad, opening_rad, position_sigma_m, existence) "
    "SELECT $1::bigint, number, id, sensor, type, object, object_type, representation, shape, "
    "CASE shape WHEN 'segment' THEN ST_MakeLine(ST_MakePoint(x, y), ST_MakePoint(x2, y2)) ELSE ST_MakePoint(x, y) END, "
    "radius_m, heading_rad, opening_rad, position_sigma_m, existence "
    "FROM jsonb_to_recordset($2::jsonb) AS f(number integer, id text, sensor text, type text, object text, "
    "object_type text, representation text, shape text, x float8, y float8, x2 float8, y2 float8, radius_m float8, "
    "heading_rad float8, opening_rad float8, position_sigma_m float8, existence float8)";

std::vector<std::string> feature_rows(const SemanticMap& map) {
  std::vector<std::string> rows;
  rows.reserve(map.features().size());
  for (const MapFeature& feature : map.features()) {
    json row = std::visit(ShapeColumns{}, feature.geometry);
    const MapObject& object = map.object(feature.object);
    row["number"] = rows.size();
    row["id"] = feature.id;
    row["sensor"] = feature.sensor;
    row["type"] = feature.type;
    row["object"] = object.id;
    row["object_type"] = object.type;
    row["representation"] = feature.representation;
    row["position_sigma_m"] = feature.position_sigma_m;
    row["existence"] = feature.existence;
    rows.push_back(row.dump());
  }
  return rows;
}

double largest_radius_m(const SemanticMap& map) {
  double largest = 0;
  for (const MapFeature& feature : map.features())
    if (const auto* circle = std::get_if<Circle>(&feature.geometry)) largest = std::max(largest, circle->radius_m);
  return largest;
}

const char* const kGeometryColumns =
    "shape, ST_X(ST_PointN(line, 1)), ST_Y(ST_PointN(line, 1)), ST_X(ST_PointN(line, -1)), ST_Y(ST_PointN(line, -1)), "
    "radius_m, heading_rad, opening_rad";

Geometry geometry_of(const std::vector<std::string>& row, std::size_t columns) {
  const std::string& shape = row.at(columns);
  const auto number = [&](std::size_t k) { return parse_number<double>(row.at(columns + k)).value_or(0); };
  const Point first(number(1), number(2));
  if (shape == "segment") return Segment{first, {number(3), number(4)}};
  if (shape == "circle") return Circle{first, number(5)};
  if (shape == "corner") return OrientedPoint{first, number(6), number(7)};
  return first;
}

}  // namespace opal::postgis_store
