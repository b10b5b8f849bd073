#include "map_assembly.hpp"

#include <opal/import_kit/oriented_corner.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace opal::grid_importer {
namespace {

constexpr const char* kSensor = "PlanarLidar2D";
// A closed chain of faces that is convex all around and no longer than this, is a pillar.
constexpr double kMaxPillarPerimeter_m = 6.0;

/// Faces along one surface, corner by corner, in the order of the surface.
struct Chain {
  std::vector<int> faces;
  std::vector<int> corners;  ///< number k: between faces k and k + 1, or the last and the first if closed
  double length = 0;

  long rank() const { return std::lround(1e4 * length); }  ///< rounding must not decide between equal ones
  bool is_closed() const { return faces.size() == corners.size(); }
};

class Chains {
 public:
  explicit Chains(const VectorMap& vectors)
      : vectors_(vectors),
        next_(vectors.faces.size(), -1),
        has_previous_(vectors.faces.size()),
        taken_(vectors.faces.size()) {
    for (std::size_t k = 0; k < vectors.corners.size(); ++k) {
      next_[static_cast<std::size_t>(vectors.corners[k].before)] = static_cast<int>(k);
      has_previous_[static_cast<std::size_t>(vectors.corners[k].after)] = true;
    }
  }

  std::vector<Chain> longest_first() {
    std::vector<Chain> chains;
    for (std::size_t face = 0; face < next_.size(); ++face)
      if (!has_previous_[face]) chains.push_back(from(face));
    for (std::size_t face = 0; face < next_.size(); ++face)
      if (!taken_[face]) chains.push_back(from(face));  // closed: any face is as good a begin as another
    std::ranges::stable_sort(chains, std::greater{}, &Chain::rank);
    return chains;
  }

 private:
  Chain from(std::size_t face) {
    Chain chain;
    while (!taken_[face]) {
      taken_[face] = true;
      chain.faces.push_back(static_cast<int>(face));
      chain.length += vectors_.faces[face].length();
      if (next_[face] < 0) break;
      chain.corners.push_back(next_[face]);
      face = static_cast<std::size_t>(vectors_.corners[static_cast<std::size_t>(next_[face])].after);
    }
    return chain;
  }

  const VectorMap& vectors_;
  std::vector<int> next_;  // number of the corner at a face's end, or -1
  std::vector<bool> has_previous_;
  std::vector<bool> taken_;
};

class Assembly {
 public:
  Assembly(const VectorMap& vectors, const OccupancyGrid& grid, double smear_m)
      : vectors_(vectors), grid_(grid), smear_m_(smear_m) {}

  std::shared_ptr<const SemanticMap> run(const std::string& name) {
    for (const RoundColumn& column : vectors_.columns) add(column);
    for (const Chain& chain : Chains(vectors_).longest_first()) add(chain);
    return SemanticMap::make(name, std::move(objects_), std::move(features_), {}, {smear_m_});
  }

 private:
  MapObjectNumber add_object(bool is_column) {
    const std::string id = is_column ? fmt::format("column-{:03}", ++columns_) : fmt::format("wall-{:04}", ++walls_);
    objects_.push_back({id, is_column ? "opal:Column" : "opal:Wall"});
    return MapObjectNumber(objects_.size() - 1);
  }

  /// A cell's own spread is the least that a grid can be off.
  double sigma_m(double rms) const { return grid_.resolution_m() * std::max(rms, 1 / std::sqrt(12.0)); }

  void add_feature(MapObjectNumber object, const std::string& id, const char* type, const Geometry& geometry,
                   double rms, std::vector<std::string> points = {}) {
    features_.push_back({id, object, type, kSensor, geometry, sigma_m(rms), 1, std::move(points)});
  }

  void add(const RoundColumn& column) {
    const MapObjectNumber object = add_object(true);
    const Circle circle{grid_.to_map(column.centre), column.radius * grid_.resolution_m()};
    add_feature(object, objects_.back().id + "/circle", "opal:Column", circle, column.rms);
  }

  Segment segment(int face) const {
    const Face& f = vectors_.faces[static_cast<std::size_t>(face)];
    return {grid_.to_map(f.begin), grid_.to_map(f.end)};
  }
  double rms(int face) const { return vectors_.faces[static_cast<std::size_t>(face)].rms; }

  OrientedPoint corner(int number) const {
    const Corner& c = vectors_.corners[static_cast<std::size_t>(number)];
    return oriented_corner(segment(c.before), segment(c.after));
  }

  bool is_pillar(const Chain& chain) const {
    const bool is_small = chain.length * grid_.resolution_m() <= kMaxPillarPerimeter_m;
    return chain.is_closed() && is_small && std::all_of(chain.corners.begin(), chain.corners.end(), [&](int number) {
             return corner(number).opening_rad > std::numbers::pi;
           });
  }

  void add(const Chain& chain) {
    const MapObjectNumber object = add_object(is_pillar(chain));
    std::vector<std::string> corner_ids;
    for (const int number : chain.corners) {
      corner_ids.push_back(fmt::format("corner-{:04}", ++corners_));
      const Corner& c = vectors_.corners[static_cast<std::size_t>(number)];
      add_feature(object, corner_ids.back(), "opal:Corner", corner(number), std::hypot(rms(c.before), rms(c.after)),
                  {corner_ids.back() + "/point"});
    }
    for (std::size_t k = 0; k < chain.faces.size(); ++k) add_face(object, chain, k, corner_ids);
  }

  void add_face(MapObjectNumber object, const Chain& chain, std::size_t k, const std::vector<std::string>& corner_ids) {
    const std::string& owner = objects_[object.number()].id;
    const std::string id = chain.faces.size() == 1 ? owner + "/face" : fmt::format("{}/face-{}", owner, k + 1);
    std::string begin = id + "/begin";
    std::string end = id + "/end";
    if (k > 0 || chain.is_closed()) begin = corner_ids[(k + corner_ids.size() - 1) % corner_ids.size()] + "/point";
    if (k < corner_ids.size()) end = corner_ids[k] + "/point";
    add_feature(object, id, "opal:Wall", segment(chain.faces[k]), rms(chain.faces[k]), {begin, end});
  }

  const VectorMap& vectors_;
  const OccupancyGrid& grid_;
  double smear_m_;
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  int walls_ = 0;
  int columns_ = 0;
  int corners_ = 0;
};

}  // namespace

std::shared_ptr<const SemanticMap> assemble(const std::string& name, const VectorMap& vectors,
                                            const OccupancyGrid& grid, double smear_m) {
  return Assembly(vectors, grid, smear_m).run(name);
}

}  // namespace opal::grid_importer
