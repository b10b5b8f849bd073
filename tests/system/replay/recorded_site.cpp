#include "recorded_site.hpp"

#include "tests/kit/shipped_plugins.hpp"

#include <opal/map/map_importer.hpp>
#include <opal/sensing/log_source.hpp>

#include <algorithm>

using namespace opal;

namespace {

std::string prefix_of(const std::string& name) { return std::string(OPAL_SOURCE_DIR) + "/maps/malaga/" + name; }

}  // namespace

RecordedSite::RecordedSite(const std::string& name, Extent extent)
    : map(shipped_plugins().make<MapImporter>("opal:GridImporter")->import(prefix_of(name) + ".map.yaml").map),
      laser(read_site_laser(prefix_of(name) + ".info.json")),
      truth(GroundTruth::read(prefix_of(name) + ".gt.csv")) {
  ReplayOptions window;
  if (extent == Extent::first_query) {
    const Query query = read_queries(prefix_of(name) + ".queries.json").front();
    window.from_s = query.start_s;
    window.to_s = query.end_s;
  }
  Replay log(shipped_plugins().make<LogSource>("opal:CarmenLog")->open(prefix_of(name) + ".log.gz"), {laser}, window);
  samples = read_all(log);
}

LocalizerParts RecordedSite::parts(std::shared_ptr<const SemanticMap> other_map) const {
  Deployment deployment = read_deployment(std::string(OPAL_SOURCE_DIR) + "/configs/default.jsonld");
  const std::string sensor = deployment.lasers.front().id;
  deployment.lasers.front() = laser;
  deployment.lasers.front().id = sensor;
  return build_parts(deployment, shipped_plugins(), std::move(other_map));
}

std::vector<ReplayedScan> replay(Localizer& localizer, const std::vector<Sample>& samples) {
  std::vector<ReplayedScan> scans;
  for (const Sample& sample : samples) {
    const bool keyframe = localizer.update(sample).has_value();
    scans.push_back({sample.stamp_s, localizer.estimate_at(sample.stamp_s, sample.T_odom_base), keyframe});
  }
  return scans;
}

std::shared_ptr<const SemanticMap> moved_map(const SemanticMap& map, const Pose2& T_new_map) {
  std::vector<MapFeature> features = map.features();
  for (MapFeature& feature : features) feature.geometry = transformed(T_new_map, feature.geometry);
  return SemanticMap::make(map.name(), map.objects(), features);
}

std::shared_ptr<const SemanticMap> reversed_map(const SemanticMap& map) {
  std::vector<MapFeature> features(map.features().rbegin(), map.features().rend());
  std::vector<MapObject> objects = map.objects();
  for (MapObject& object : objects)
    for (MapFeatureNumber& number : object.features) number = MapFeatureNumber(features.size() - 1 - number.number());
  return SemanticMap::make(map.name(), objects, features);
}
