#include "openings.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace opal::geojson_importer {
namespace {

constexpr double kAlongSine = 0.17;  // 10 degrees
constexpr double kShortestWall_m = 0.02;
constexpr double kNarrowest_m = 0.3, kWidest_m = 20;

const AreaWall* nearest_to(const Point& p, double at_most_m, const std::vector<AreaWall>& walls) {
  const AreaWall* nearest = nullptr;
  for (const AreaWall& wall : walls)
    if (const double d = opal::distance_m(wall.line, p); d <= at_most_m) {
      nearest = &wall;
      at_most_m = d;
    }
  return nearest;
}

/// The place of a door within its wall; at the end of a wall, it does not go on into the next one.
std::optional<Segment> place_of(const Opening& opening, double thickness_m, const std::vector<AreaWall>& walls) {
  if (!opening.is_point()) return opening.line;
  const AreaWall* wall = nearest_to(opening.line.begin, thickness_m, walls);
  if (wall == nullptr) return std::nullopt;
  const Point along = wall->line.direction();
  const double length_m = wall->line.length_m(), half_m = std::min(opening.width_m, length_m) / 2;
  const double middle = std::clamp(along.dot(opening.line.begin - wall->line.begin), half_m, length_m - half_m);
  return Segment{wall->line.begin + (middle - half_m) * along, wall->line.begin + (middle + half_m) * along};
}

/// What is left of a wall where an opening is: none, one or two pieces. @return whether anything was taken.
bool cut(const AreaWall& wall, const Segment& opening, double thickness_m, std::vector<AreaWall>& left) {
  const Point along = wall.line.direction();
  const double length_m = wall.line.length_m();
  const double begin = along.dot(opening.begin - wall.line.begin), end = along.dot(opening.end - wall.line.begin);
  const double from = std::min(begin, end), to = std::max(begin, end);
  const Point middle = (opening.begin + opening.end) / 2;
  const bool is_beside = std::abs(cross(along, opening.direction())) < kAlongSine &&
                         std::abs(cross(along, middle - wall.line.begin)) <= thickness_m;
  if (!is_beside || to < kShortestWall_m || from > length_m - kShortestWall_m) {
    left.push_back(wall);
    return false;
  }
  if (from > kShortestWall_m) left.push_back({wall.element, {wall.line.begin, wall.line.begin + from * along}});
  if (to < length_m - kShortestWall_m) left.push_back({wall.element, {wall.line.begin + to * along, wall.line.end}});
  return true;
}

/// "0.9", "90 cm", 0.9; none if the property says no length.
std::optional<double> length_m_at(const Feature& feature, const char* key) {
  const std::string text = text_or_number(feature, key);
  double length = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (error != std::errc()) return std::nullopt;
  const std::string unit(end, text.data() + text.size());
  if (unit.find("cm") != std::string::npos) length /= 100;
  if (unit.find("mm") != std::string::npos) length /= 1000;
  return length;
}

}  // namespace

std::optional<double> width_m_of(const Feature& feature) {
  for (const char* key : {"width", "door:width", "width_m", "est_width"})
    if (const auto width = length_m_at(feature, key); width && *width >= kNarrowest_m && *width <= kWidest_m)
      return width;
  return std::nullopt;
}

std::optional<double> wall_width_m_of(const Feature& feature) {
  for (const char* key : {"width", "width_m", "thickness"})
    if (const auto width = length_m_at(feature, key); width && *width > 0) return width;
  return std::nullopt;
}

Segment line_through(const Ring& ring) {
  Segment longest{ring.front(), ring.front()};
  for (std::size_t k = 0; k < ring.size(); ++k)
    if (const Segment edge{ring[k], ring[(k + 1) % ring.size()]}; edge.length_m() > longest.length_m()) longest = edge;
  if (longest.length_m() == 0) return longest;
  const Point along = longest.direction(), across = left_of(along);
  Eigen::AlignedBox2d box;
  for (const Point& p : ring) box.extend(Point(along.dot(p - ring.front()), across.dot(p - ring.front())));
  const Point begin = ring.front() + box.min().x() * along + box.center().y() * across;
  return {begin, begin + box.sizes().x() * along};
}

std::vector<std::optional<Segment>> cut_openings(const std::vector<Opening>& openings, double thickness_m,
                                                 std::vector<AreaWall>& walls) {
  std::vector<std::optional<Segment>> places;
  for (const Opening& opening : openings) places.push_back(place_of(opening, thickness_m, walls));
  for (std::optional<Segment>& place : places) {
    if (!place || place->length_m() < kShortestWall_m) continue;
    std::vector<AreaWall> left;
    bool is_cut = false;
    for (const AreaWall& wall : walls) is_cut |= cut(wall, *place, thickness_m, left);
    walls = std::move(left);
    if (!is_cut) place.reset();
  }
  return places;
}

}  // namespace opal::geojson_importer
