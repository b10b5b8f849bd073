#include "map_tools/map_join.hpp"

#include <opal/common/error.hpp>

#include "common/geometry_box.hpp"
#include "map/semantic_map_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace opal {
namespace {

Eigen::AlignedBox2d bounds_of(const SemanticMap& map) {
  Eigen::AlignedBox2d bounds;
  for (const MapFeature& feature : map.features()) bounds.extend(box_of(feature.geometry));
  return bounds;
}

Eigen::AlignedBox2d scaled(const Eigen::AlignedBox2d& box, const Point& scale) {
  return Eigen::AlignedBox2d(scale.cwiseProduct(box.min())).extend(scale.cwiseProduct(box.max()));
}

/// Fills rows from below, left to right; a row ends where it would be longer than the whole is going to be high.
class Rows {
 public:
  Rows(double row_length_m, double gap_m) : row_length_m_(row_length_m), gap_m_(gap_m) {}

  /// Where the lower left corner of a thing of this size goes: whole metres.
  Point next(const Point& size) {
    if (at_.x() > 0 && at_.x() + size.x() > row_length_m_) {
      at_ = {0, at_.y() + row_height_m_};
      row_height_m_ = 0;
    }
    const Point place = at_;
    at_.x() += std::ceil(size.x() + gap_m_);
    row_height_m_ = std::max(row_height_m_, std::ceil(size.y() + gap_m_));
    return place;
  }

 private:
  double row_length_m_, gap_m_;
  Point at_ = Point::Zero();
  double row_height_m_ = 0;
};

class Join {
 public:
  Join(std::span<const MapSourcePart> sources, const MapJoin& join) : sources_(sources), join_(join) {
    check();
    for (const MapSourcePart& source : sources) bounds_.push_back(bounds_of(*source.map));
  }

  std::shared_ptr<const SemanticMap> run() {
    for (std::size_t k = 0; k < sources_.size(); ++k)
      if (bounds_[k].isEmpty())
        throw MapError(sources_[k].map->name() + ": has no features, expected some to be joined");
    place_all();
    for (std::size_t k = 0; k < placements_.size(); ++k) add(*sources_[k % sources_.size()].map, placements_[k]);
    double smear_m = 0;
    for (const MapSourcePart& source : sources_) smear_m = std::max(smear_m, source.map->origin().smear_m);
    return SemanticMap::make("joined", std::move(objects_), std::move(features_), std::move(patterns_),
                             {smear_m, std::move(placements_)});
  }

 private:
  void check() const {
    if (sources_.empty()) throw ConfigError("join: no maps, expected at least one");
    if (!(join_.gap_m >= 0 && join_.gap_m <= 1e4))
      throw ConfigError("join: gap " + text_of(join_.gap_m) + ", expected metres from 0 to 10000");
    if (join_.copies < 0 || join_.copies > 1000)
      throw ConfigError(fmt::format("join: {} copies, expected 0 to 1000", join_.copies));
    std::set<std::string> prefixes;
    for (const MapSourcePart& source : sources_) {
      if (source.prefix.empty()) throw ConfigError("join: a map without a prefix, expected a name");
      if (!prefixes.insert(source.prefix).second)
        throw ConfigError("join: two maps are called '" + source.prefix + "', expected a name for each");
      if (!source.map->origin().placements.empty())
        throw MapError(source.map->name() + ": is a joined map, expected maps that are not");
    }
  }

  /// The originals first, then copy by copy, each with its own distortion.
  void place_all() {
    std::mt19937_64 random(join_.seed);
    std::vector<Point> scales{Point(1, 1)};
    for (int k = 0; k < join_.copies; ++k) {
      const double x = stretch(random), y = stretch(random);
      scales.emplace_back(-x, y);
    }
    double area = 0;
    for (const Point& scale : scales)
      for (const Eigen::AlignedBox2d& bounds : bounds_) {
        const Point size = scaled(bounds, scale).sizes() + Point::Constant(join_.gap_m);
        area += size.x() * size.y();
      }
    Rows rows(std::sqrt(area), join_.gap_m);
    for (std::size_t copy = 0; copy < scales.size(); ++copy)
      for (std::size_t k = 0; k < sources_.size(); ++k) {
        const Eigen::AlignedBox2d bounds = scaled(bounds_[k], scales[copy]);
        const Point move = rows.next(bounds.sizes()) - Point(bounds.min().array().floor());
        const std::string id = (copy > 0 ? fmt::format("copy-{}/", copy) : "") + sources_[k].prefix;
        placements_.push_back({id, Pose2(move, 0), scales[copy]});
      }
  }

  /// Five to thirty per cent. Not std::uniform_real_distribution, which may differ between libraries.
  static double stretch(std::mt19937_64& random) { return 1.05 + 0.25 * static_cast<double>(random() >> 11) * 0x1p-53; }

  static void put_before(const std::string& prefix, std::string& id) {
    if (!id.empty()) id = prefix + id;
  }

  void add(const SemanticMap& map, const MapPlacement& placement) {
    const std::string prefix = placement.id + "/";
    const std::size_t first_object = objects_.size(), first_feature = features_.size();
    for (const MapObject& object : map.objects())
      objects_.push_back({prefix + object.id, object.type, {}, placed(placement, object.notes)});
    for (MapFeature feature : map.features()) {
      feature.object = MapObjectNumber(first_object + feature.object.number());
      put_before(prefix, feature.id);
      put_before(prefix, feature.representation);
      for (std::string& point : feature.points) put_before(prefix, point);
      const bool mirrored = placement.scale.x() * placement.scale.y() < 0;
      if (mirrored && feature.points.size() == 2) std::swap(feature.points[0], feature.points[1]);
      feature.geometry = placed(placement, feature.geometry);
      features_.push_back(std::move(feature));
    }
    if (!placement.is_rigid()) return;
    for (MapPattern pattern : map.patterns()) {
      put_before(prefix, pattern.id);
      for (MapFeatureNumber& feature : pattern.features) feature = MapFeatureNumber(first_feature + feature.number());
      for (std::string& part : pattern.subpatterns) put_before(prefix, part);
      patterns_.push_back(std::move(pattern));
    }
  }

  std::span<const MapSourcePart> sources_;
  const MapJoin& join_;
  std::vector<Eigen::AlignedBox2d> bounds_;
  std::vector<MapPlacement> placements_;
  std::vector<MapObject> objects_;
  std::vector<MapFeature> features_;
  std::vector<MapPattern> patterns_;
};

}  // namespace

std::shared_ptr<const SemanticMap> joined_map(std::span<const MapSourcePart> sources, const MapJoin& join) {
  return Join(sources, join).run();
}

}  // namespace opal
