#include <opal/deployment/deployment.hpp>

#include "common/json/config_object.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include <opal/localization/options/caution.hpp>
#include "deployment/localizer_options.hpp"
#include "deployment/store_source.hpp"
#include "deployment/trusted_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>

namespace opal {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr NumberRange kLength_m{0, 1000};
constexpr NumberRange kSomeLength_m{1e-4, 1000};
constexpr NumberRange kAngle_rad{0, 2 * kPi};
constexpr NumberRange kSigma{0, 100};

Pose2 read_mount(ConfigObject mount) {
  const NumberRange place_m{-100, 100}, heading_rad{-2 * kPi, 2 * kPi};
  const double x_m = mount.number("x_m", 0, place_m), y_m = mount.number("y_m", 0, place_m);
  const Pose2 T_base_laser(x_m, y_m, mount.number("heading_rad", 0, heading_rad));
  mount.expect_no_more();
  return T_base_laser;
}

CloudSlice read_slice(ConfigObject object) {
  const NumberRange height_m{-100, 100}, angle_rad{-2 * kPi, 2 * kPi};
  CloudSlice slice;
  slice.z_min_m = object.number("z_min_m", slice.z_min_m, height_m);
  slice.z_max_m = object.number("z_max_m", slice.z_max_m, height_m);
  slice.height_m = object.number("height_m", slice.height_m, height_m);
  slice.roll_rad = object.number("roll_rad", slice.roll_rad, angle_rad);
  slice.pitch_rad = object.number("pitch_rad", slice.pitch_rad, angle_rad);
  object.expect_no_more();
  if (slice.z_max_m <= slice.z_min_m) object.refuse("z_max_m", "more than z_min_m");
  return slice;
}

/// A 3D lidar usually sees all around: half a degree from one direction of its slice to the next.
LaserModel sliced_laser(const CloudSlice& slice) {
  LaserModel laser;
  laser.slice = slice;
  laser.beams = 720;
  laser.angle_min_rad = -kPi;
  laser.angle_increment_rad = 2 * kPi / laser.beams;
  return laser;
}

LaserModel read_sensor(ConfigObject sensor) {
  const auto slice = sensor.object("slice");
  LaserModel laser = slice ? sliced_laser(read_slice(*slice)) : LaserModel{};
  laser.id = sensor.text("id", laser.id);
  laser.frame = sensor.text("frame", laser.frame);
  laser.topic = sensor.text("topic", laser.topic);
  laser.angle_min_rad = sensor.number("angle_min_rad", laser.angle_min_rad, {-2 * kPi, 2 * kPi});
  if (const nlohmann::json& step = sensor.any("angle_increment_rad"); step.is_number() && step.get<double>() < 0)
    sensor.refuse("angle_increment_rad", "a number above 0; geometry_from_log takes beams that turn clockwise");
  laser.angle_increment_rad = sensor.number("angle_increment_rad", laser.angle_increment_rad, {1e-5, kPi});
  laser.beams = sensor.integer("beams", laser.beams, {1, 100000});
  laser.range_min_m = sensor.number("range_min_m", laser.range_min_m, kLength_m);
  laser.range_max_m = sensor.number("range_max_m", laser.range_max_m, kSomeLength_m);
  laser.no_return_m = sensor.number("no_return_m", laser.no_return_m, {1e-4, 1e9});
  laser.range_sigma_m = sensor.number("range_sigma_m", laser.range_sigma_m, {1e-4, 10});
  laser.geometry_from_log = sensor.boolean("geometry_from_log", laser.geometry_from_log);
  if (!sensor.any("sweep_s").is_null()) laser.sweep_s = sensor.number("sweep_s", 0, {0, 10});
  if (auto mount = sensor.object("T_base_laser")) laser.T_base_laser = read_mount(*mount);
  sensor.expect_no_more();
  if (laser.slice && laser.topic.empty()) sensor.refuse("topic", "the topic of the point clouds that are sliced");
  if (laser.range_max_m <= laser.range_min_m) sensor.refuse("range_max_m", "more than range_min_m");
  const double widest_rad = 2 * kPi / std::max(1, laser.beams - 1);
  if (laser.angle_increment_rad > 1.001 * widest_rad && !laser.geometry_from_log)
    sensor.refuse("angle_increment_rad",
                  fmt::format("at most {:.4g}: {} beams then cover a full turn, and one of half a "
                              "degree is 0.00873",
                              widest_rad, laser.beams));
  return laser;
}

OdometryScale read_odometry(ConfigObject object) {
  const NumberRange scale{0.01, 100};
  OdometryScale odometry;
  odometry.distance = object.number("distance_scale", odometry.distance, scale);
  odometry.turn = object.number("turn_scale", odometry.turn, scale);
  object.expect_no_more();
  return odometry;
}

KeyframeOptions read_keyframes(ConfigObject object) {
  KeyframeOptions keyframes;
  keyframes.distance_m = object.number("distance_m", keyframes.distance_m, kLength_m);
  keyframes.angle_rad = object.number("angle_rad", keyframes.angle_rad, kAngle_rad);
  object.expect_no_more();
  return keyframes;
}

struct LocalMapField {
  const char* name;
  double LocalMapOptions::*member;
  NumberRange range;
};

LocalMapOptions read_local_map(ConfigObject object) {
  using O = LocalMapOptions;
  static const LocalMapField fields[] = {
      {"horizon_m", &O::horizon_m, {0.1, 1000}},
      {"horizon_m_per_rad", &O::horizon_m_per_rad, {0, 1000}},
      {"association_offset_m", &O::association_offset_m, kLength_m},
      {"association_distance_m", &O::association_distance_m, kLength_m},
      {"association_angle_rad", &O::association_angle_rad, kAngle_rad},
      {"association_radius_m", &O::association_radius_m, kLength_m},
      {"pose_change_m", &O::pose_change_m, kLength_m},
      {"pose_change_rad", &O::pose_change_rad, kAngle_rad},
      {"robust_scale", &O::robust_scale, {1e-3, 1000}},
      {"odometry_sigma_per_m", &O::odometry_sigma_per_m, kSigma},
      {"odometry_heading_sigma_per_rad", &O::odometry_heading_sigma_per_rad, kSigma},
      {"odometry_heading_sigma_per_m", &O::odometry_heading_sigma_per_m, kSigma},
  };
  LocalMapOptions options;
  for (const LocalMapField& field : fields)
    options.*field.member = object.number(field.name, options.*field.member, field.range);
  options.stable_after = object.integer("stable_after", options.stable_after, {1, 1000});
  options.optimize_every = object.integer("optimize_every", options.optimize_every, {0, 1000});
  object.expect_no_more();
  return options;
}

/// The members that every part has; the caller may ask for more before `expect_no_more`.
PartConfig read_part(ConfigObject& object) {
  PartConfig part{object.required_text("@type"), nlohmann::json::object(), object.where()};
  if (object.object("options")) part.options = object.any("options");
  return part;
}

PartConfig read_whole_part(ConfigObject object) {
  PartConfig part = read_part(object);
  object.expect_no_more();
  return part;
}

/// A type named twice would shadow its first options.
std::vector<PartConfig> read_parts(const std::vector<ConfigObject>& objects) {
  std::vector<PartConfig> parts;
  for (const ConfigObject& object : objects) {
    PartConfig part = read_whole_part(object);
    for (const PartConfig& other : parts)
      if (other.type == part.type) object.refuse("@type", "a type that is not in the list already");
    parts.push_back(std::move(part));
  }
  return parts;
}

ScorerConfig read_scorer(ConfigObject object) {
  ScorerConfig scorer;
  scorer.part = read_part(object);
  const std::string role = object.text("role", "decides");
  if (role != "decides" && role != "observes") object.refuse("role", "\"decides\" or \"observes\"");
  scorer.role = role == "decides" ? ScorerRole::decides : ScorerRole::observes;
  scorer.weight = object.number("weight", 1, {0, 1000});
  object.expect_no_more();
  return scorer;
}

bool decides_already(const std::vector<ScorerConfig>& scorers, const ScorerConfig& scorer) {
  return std::ranges::any_of(scorers, [&](const ScorerConfig& other) {
    return other.decides() && scorer.decides() && other.part.type == scorer.part.type &&
           other.part.options == scorer.part.options;
  });
}

std::vector<ScorerConfig> read_scorers(ConfigObject& document) {
  constexpr const char* kExpected = "at least one with role \"decides\" and a weight above 0";
  const auto objects = document.list("scorers");
  if (!objects) document.refuse("scorers", kExpected);
  std::vector<ScorerConfig> scorers;
  bool decided = false;
  for (const ConfigObject& object : *objects) {
    ScorerConfig scorer = read_scorer(object);
    if (decides_already(scorers, scorer))
      object.refuse("@type",
                    "a scorer that does not decide already with these options: its evidence would count twice");
    decided = decided || (scorer.decides() && scorer.weight > 0);
    scorers.push_back(std::move(scorer));
  }
  if (!decided) throw ConfigError(document.where("scorers") + ": no scorer decides, expected " + kExpected);
  return scorers;
}

std::string resolve(const std::string& path, const std::string& document) {
  if (path.empty() || read_store_source(path)) return path;
  return beside(document, path);
}

/// Several lasers are told apart by their frames, and what the map offers to perceive is the same for all.
void expect_distinct(const ConfigObject& document, const std::vector<LaserModel>& lasers) {
  std::set<std::string> frames;
  for (std::size_t k = 0; k < lasers.size(); ++k) {
    const std::string place = document.where("sensor") + "/" + std::to_string(k);
    if (lasers[k].id != lasers.front().id)
      throw ConfigError(place + "/id: \"" + lasers[k].id + "\", expected \"" + lasers.front().id +
                        "\" as for the first sensor");
    if (lasers.size() > 1 && !frames.insert(lasers[k].frame).second)
      throw ConfigError(place + "/frame: \"" + lasers[k].frame + "\", expected a frame that no other sensor has");
  }
}

/// One sensor, or a list of them.
void read_sensors(ConfigObject& document, Deployment& deployment) {
  const nlohmann::json& described = document.any("sensor");
  if (described.is_null()) return;
  if (!described.is_array()) {
    deployment.lasers = {read_sensor(*document.object("sensor"))};
    deployment.describes_laser = described.size() > described.count("id");
    deployment.describes_mount = described.contains("T_base_laser");
    return;
  }
  const auto sensors = document.list("sensor");
  if (sensors->empty()) document.refuse("sensor", "a sensor, or a list of at least one");
  deployment.lasers.clear();
  for (const ConfigObject& sensor : *sensors) deployment.lasers.push_back(read_sensor(sensor));
  deployment.describes_laser = true;
  deployment.describes_mount =
      std::ranges::all_of(described, [](const auto& sensor) { return sensor.contains("T_base_laser"); });
  expect_distinct(document, deployment.lasers);
}

Caution read_caution(ConfigObject& document) {
  const std::string caution = document.text("caution", "usual");
  if (caution == "usual") return Caution::usual;
  if (caution == "careful") return Caution::careful;
  if (caution == "strict") return Caution::strict;
  document.refuse("caution", R"("usual", "careful" or "strict")");
}

/// What the document prefers, and what it changes of that.
LocalizerOptions read_stages(ConfigObject& document) {
  const LocalizerOptions preferred = options_of(read_caution(document));
  if (!document.object("stages")) return preferred;
  return read_localizer_options(document.any("stages"), document.where("stages"), preferred);
}

Deployment read(const nlohmann::json& json, const std::string& file) {
  if (json.contains("@graph"))
    throw ConfigError(file + ": is a map, expected a deployment document; a map is named behind --map");
  ConfigObject document(json, file);
  document.expect_type("opal:Deployment");
  Deployment deployment;
  deployment.file = file;
  document.text("name", "");
  document.text("comment", "");
  deployment.map = resolve(document.text("map", ""), file);
  for (const std::string& path : document.texts("overlays")) deployment.overlays.push_back(resolve(path, file));
  read_sensors(document, deployment);
  if (auto odometry = document.object("odometry")) deployment.odometry = read_odometry(*odometry);
  if (auto keyframes = document.object("keyframes")) deployment.keyframes = read_keyframes(*keyframes);
  if (auto local_map = document.object("local_map")) deployment.local_map = read_local_map(*local_map);
  if (auto matcher = document.object("matcher")) deployment.matcher = read_whole_part(*matcher);
  if (auto detectors = document.list("detectors")) deployment.detectors = read_parts(*detectors);
  if (auto patterns = document.list("patterns")) deployment.patterns = read_parts(*patterns);
  if (auto importers = document.list("importers")) deployment.importers = read_parts(*importers);
  if (auto sources = document.list("log_sources")) deployment.log_sources = read_parts(*sources);
  deployment.trusted_plugins = read_trusted_plugins(document, file);
  deployment.scorers = read_scorers(document);
  deployment.stages = read_stages(document);
  document.expect_no_more();
  return deployment;
}

}  // namespace

Deployment read_deployment(const std::string& path) { return read(read_json(path), path); }

Deployment parse_deployment(const std::string& text, const std::string& file) {
  return read(parse_json(text, file), file);
}

bool takes_geometry_from_log(const Deployment& deployment) {
  return std::ranges::any_of(deployment.lasers, [](const LaserModel& laser) { return laser.geometry_from_log; });
}

Deployment with_lasers(Deployment deployment, std::vector<LaserModel> lasers) {
  const std::string sensor = deployment.lasers.front().id;
  deployment.lasers = std::move(lasers);
  deployment.describes_mount = true;
  for (LaserModel& laser : deployment.lasers) laser.id = sensor;
  return deployment;
}

}  // namespace opal
