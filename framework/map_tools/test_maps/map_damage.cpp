#include "map_tools/test_maps/map_damage.hpp"

#include <opal/common/error.hpp>

#include "map/semantic_map_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <sstream>

namespace opal {
namespace {

/// Works on copies of a map's objects and features; features are deleted by marking them.
class Vandal {
 public:
  Vandal(const SemanticMap& map, const MapDamage& damage)
      : map_(map),
        damage_(damage),
        random_(damage.seed),
        features_(map.features()),
        gone_(features_.size(), false),
        moved_by_(features_.size(), Point::Zero()) {
    for (std::size_t k = 0; k < features_.size(); ++k)
      for (const std::string& point : features_[k].points) users_[point].push_back(k);
  }

  std::shared_ptr<const SemanticMap> run() {
    for (std::size_t k = 0; k < features_.size(); ++k)
      if (segment(k) && segment(k)->length_m() < damage_.plan_m) gone_[k] = true;
    for (std::size_t k : segments())
      if (uniform(0, 1) < damage_.drop) gone_[k] = true;
    if (damage_.wall_m > 0) move_walls();
    if (damage_.shift_m > 0)
      for (std::size_t k : segments())
        moved_by_[k] += std::normal_distribution<double>(0, damage_.shift_m)(random_) * segment(k)->normal();
    move_points();
    delete_loose_corners();
    return assemble();
  }

 private:
  const Segment* segment(std::size_t k) const { return std::get_if<Segment>(&features_[k].geometry); }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  std::vector<std::size_t> segments() const {
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < features_.size(); ++k)
      if (!gone_[k] && segment(k)) left.push_back(k);
    return left;
  }

  void move_walls() {
    std::map<MapObjectNumber, std::vector<std::size_t>> walls;  // by object
    for (std::size_t k : segments()) walls[features_[k].object].push_back(k);
    for (const auto& [object, faces] : walls) {
      const bool chosen = uniform(0, 1) < damage_.wall_share;
      const double by_m = uniform(-damage_.wall_m, damage_.wall_m);
      if (!chosen) continue;
      const std::size_t longest = *std::ranges::max_element(
          faces, [&](std::size_t a, std::size_t b) { return segment(a)->length_m() < segment(b)->length_m(); });
      for (std::size_t k : faces) moved_by_[k] += by_m * segment(longest)->normal();
    }
  }

  /// Where a point goes: to where its faces meet after they were moved, or along with them.
  Point moved(const Point& p, const std::vector<std::size_t>& faces) const {
    Point mean = Point::Zero();
    for (std::size_t k : faces) mean += moved_by_[k] / static_cast<double>(faces.size());
    if (faces.size() != 2) return p + mean;
    const Point a = segment(faces[0])->normal(), b = segment(faces[1])->normal();
    const double sine = cross(a, b);
    if (std::abs(sine) < 0.3) return p + mean;
    Eigen::Matrix2d normals;
    normals << a.transpose(), b.transpose();
    return p + normals.inverse() * Point(a.dot(moved_by_[faces[0]]), b.dot(moved_by_[faces[1]]));
  }

  void move_points() {
    std::vector<MapFeature> after = features_;
    for (const auto& [name, users] : users_) {
      std::vector<std::size_t> faces;
      for (std::size_t k : users)
        if (!gone_[k] && segment(k) && std::ranges::find(faces, k) == faces.end()) faces.push_back(k);
      if (faces.empty()) continue;
      for (std::size_t k : users) {
        const std::vector<Point*> points = points_of(after[k].geometry);
        for (std::size_t i = 0; i < points.size(); ++i)
          if (features_[k].points[i] == name) *points[i] = moved(*points[i], faces);
      }
    }
    for (std::size_t k = 0; k < after.size(); ++k) {  // faces may have been squeezed to nothing, or turned over
      const auto* now = std::get_if<Segment>(&after[k].geometry);
      if (now && (now->end - now->begin).dot(segment(k)->direction()) < 0.05) gone_[k] = true;
    }
    features_ = std::move(after);
  }

  void delete_loose_corners() {
    for (std::size_t k = 0; k < features_.size(); ++k) {
      if (!std::holds_alternative<OrientedPoint>(features_[k].geometry)) continue;
      for (std::size_t other : users_[features_[k].points.front()]) gone_[k] = gone_[k] || gone_[other];
    }
  }

  void add_false(std::vector<MapObject>& objects, std::vector<MapFeature>& features) {
    const std::vector<std::size_t> real = segments();
    if (real.empty()) return;
    const auto pick = [&] { return real[std::uniform_int_distribution<std::size_t>(0, real.size() - 1)(random_)]; };
    const auto count = static_cast<std::size_t>(std::llround(damage_.false_share * static_cast<double>(real.size())));
    for (std::size_t n = 0; n < count; ++n) {
      // As long and as straight as the real ones, near them, but nowhere in particular.
      const Segment like = *segment(pick()), where = *segment(pick());
      const double off_y_m = uniform(-4, 4), off_x_m = uniform(-4, 4);  // one by one: arguments have no order
      const Point from = where.midpoint() + Point(off_x_m, off_y_m);
      MapFeature feature = map_.features()[pick()];
      feature.id = fmt::format("false-{}/face", n + 1);
      feature.object = MapObjectNumber(objects.size());
      feature.geometry = Segment{from, from + (uniform(0, 1) < 0.5 ? 1 : -1) * (like.end - like.begin)};
      feature.points.clear();
      feature.representation.clear();
      objects.push_back({fmt::format("false-{}", n + 1), "opal:Wall"});
      features.push_back(feature);
    }
  }

  std::shared_ptr<const SemanticMap> assemble() {
    std::vector<MapObject> objects = map_.objects();
    for (MapObject& object : objects) object.features.clear();
    std::vector<MapFeature> features;
    for (std::size_t k = 0; k < features_.size(); ++k)
      if (!gone_[k]) features.push_back(features_[k]);
    add_false(objects, features);
    return SemanticMap::make(map_.name(), std::move(objects), std::move(features), {}, map_.origin());
  }

  const SemanticMap& map_;
  const MapDamage& damage_;
  std::mt19937_64 random_;
  std::vector<MapFeature> features_;
  std::vector<bool> gone_;
  std::vector<Point> moved_by_;
  std::map<std::string, std::vector<std::size_t>> users_;  ///< features by the points that make them
};

double read_number(const std::string& part, const std::string& text, double most) {
  std::size_t used = 0;
  double value = -1;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
  }
  if (used != text.size() || !(value >= 0 && value <= most)) {
    std::ostringstream message;
    message << "damage: " << part << ": '" << text << "', expected a number from 0 to " << most;
    throw ConfigError(message.str());
  }
  return value;
}

}  // namespace

MapDamage read_map_damage(const std::string& text, MapDamage damage) {
  struct Part {
    double* value;
    double most;
  };
  const std::map<std::string, Part> parts{
      {"thick", {&damage.thick_m, 2}},     {"plan", {&damage.plan_m, 100}},         {"drop", {&damage.drop, 1}},
      {"wall", {&damage.wall_m, 10}},      {"wall_share", {&damage.wall_share, 1}}, {"shift", {&damage.shift_m, 10}},
      {"false", {&damage.false_share, 10}}};
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const std::size_t equals = word.find('=');
    const auto part = parts.find(word.substr(0, equals));
    if (equals == std::string::npos || part == parts.end())
      throw ConfigError("damage: '" + word +
                        "', expected thick=, plan=, drop=, wall=, wall_share=, shift= or false= and a number");
    *part->second.value = read_number(part->first, word.substr(equals + 1), part->second.most);
  }
  return damage;
}

std::shared_ptr<const SemanticMap> damaged_map(const SemanticMap& map, const MapDamage& damage) {
  return Vandal(map, damage).run();
}

}  // namespace opal
