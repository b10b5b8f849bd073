#include "common/json/event_json.hpp"

namespace opal {
namespace {

struct GeometryMember {
  nlohmann::ordered_json& object;
  void operator()(const Point& p) const { object["point"] = {p.x(), p.y()}; }
  void operator()(const OrientedPoint& p) const {
    object["oriented_point"] = {p.position.x(), p.position.y(), p.heading_rad, p.opening_rad};
  }
  void operator()(const Segment& s) const { object["segment"] = {s.begin.x(), s.begin.y(), s.end.x(), s.end.y()}; }
  void operator()(const Circle& c) const { object["circle"] = {c.center.x(), c.center.y(), c.radius_m}; }
};

double to_millimetre(double value) { return std::round(1e3 * value) / 1e3; }

}  // namespace

nlohmann::ordered_json pose_json(const Pose2& pose) {
  return nlohmann::ordered_json::array({pose.x(), pose.y(), pose.heading_rad()});
}

void add_geometry(nlohmann::ordered_json& object, const Geometry& geometry) {
  std::visit(GeometryMember{object}, geometry);
}

nlohmann::ordered_json points_json(std::span<const Point> points) {
  auto flat = nlohmann::ordered_json::array();
  for (const Point& p : points) {
    flat.push_back(to_millimetre(p.x()));
    flat.push_back(to_millimetre(p.y()));
  }
  return flat;
}

}  // namespace opal
