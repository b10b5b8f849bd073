#pragma once

#include <opal/common/geometry.hpp>
#include <opal/local_map/local_map_ids.hpp>
#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/map/map_numbers.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What `run` and `map` say about a whole recording. Frame: `map` [m, rad]. Numbers are positions in `objects` and
/// `features`, which are those of the map that the run was made with.
struct RunHeader {
  std::string opal, log, config, map_file, sensor;
  Pose2 T_base_laser;
  double range_max_m = 0;

  struct Object {
    std::string id, type;
    std::string name = {};        ///< that people gave it; may be empty
    bool name_is_shared = false;  ///< another object of its type has the same name
  };
  struct Feature {
    std::string id;
    MapObjectNumber object = {};
    std::string type;
    bool perceivable = true;  ///< by the run's sensor; only such features take part in associations
    Geometry geometry;
  };
  struct Pattern {
    std::string id, pattern_template;
    std::vector<MapFeatureNumber> features;
  };
  /// A sheet of a map that holds several storeys.
  struct Storey {
    std::string id, name;                                       ///< "Third floor of GDC"
    Point origin = Point::Zero();                               ///< of the storey's own frame
    std::array<Point, 2> bounds{Point::Zero(), Point::Zero()};  ///< least and greatest corner of what lies on it
  };
  std::string map_name;
  std::vector<Storey> storeys;
  std::vector<Object> objects;
  std::vector<Feature> features;
  std::vector<Pattern> patterns;

  /// The storey on whose sheet a point lies; null if the map holds no storeys.
  const Storey* storey_at(const Point& p_map) const;
  const Object& object(MapObjectNumber number) const { return objects[number.number()]; }
  const Feature& feature(MapFeatureNumber number) const { return features[number.number()]; }
};

struct RecordedTerm {
  std::string scorer, term;
  double value = 0;
};

/// What a scorer saw for or against a hypothesis. Frame of `line`: `map` [m].
struct RecordedFinding {
  std::string scorer, words;
  MapFeatureNumber map_feature = {};
  std::vector<Point> line;  ///< two points, or empty
};

struct RecordedLocalFeature {
  LocalFeatureId id = {};
  std::string type;
  bool stable = false;
  int measurements = 0;
  Geometry geometry;  ///< frame `local`
};

struct RecordedHypothesis {
  HypothesisId id = {};
  Pose2 T_map_base;
  double log_likelihood = 0;  ///< [nat]
  double scan_nat = 0;        ///< of the newest scan
  double probability = 0;
  std::vector<RecordedTerm> scores;
};

struct RecordedSpawn {
  HypothesisId id = {};
  HypothesisId parent = {};  ///< none: from a search
  std::string origin;  ///< template of its pattern, or what else it comes from in words; empty: a parent, or unknown
  Pose2 T_map_base;
  double log_likelihood = 0;
  std::vector<Association> pairs;
};

struct RecordedGrowth {
  HypothesisId hypothesis = {};
  std::vector<Association> pairs;
};

struct RecordedLoss {
  HypothesisId hypothesis = {};
  std::vector<LocalFeatureId> local_features;
  std::string reason;
};

struct RecordedRejection {
  HypothesisId hypothesis = {};  ///< the parent
  std::vector<Association> pairs;
  std::string reason;
};

struct RecordedEnd {
  HypothesisId id = {};
  std::string reason;
  HypothesisId merged_into = {};
  Pose2 T_map_base;
  double log_likelihood = 0, scan_nat = 0;
  std::vector<RecordedTerm> scores;
  std::vector<RecordedFinding> findings;
};

struct RecordedSearch {
  struct Lookup {
    std::string pattern_template;
    std::vector<LocalFeatureId> local_features;
    int candidates = 0;
  };
  struct Rejected {
    std::string origin;  ///< as of a spawn
    Pose2 T_map_base;
    std::vector<Association> pairs;
    double nat = 0;
    std::string reason;
  };
  std::vector<Lookup> patterns;
  int proposed = 0;
  std::vector<Rejected> rejected;
};

/// Everything about one update of the localizer: all events of one keyframe, between `keyframe` and `cost`.
/// docs/events.md says what each means.
struct RunFrame {
  KeyframeId keyframe = {};
  double stamp_s = 0;
  double time_s = 0;                  ///< since the first update of the time line; a clock that is set back stops it
  std::optional<std::string> starts;  ///< name of the time line that begins here
  Pose2 T_local_base;
  bool scan_match = false;
  std::vector<Point> scan;        ///< base_link
  std::vector<Point> free_space;  ///< base_link
  std::vector<RecordedLocalFeature> changed;
  std::vector<LocalFeatureId> gone;
  std::optional<RecordedSearch> search;
  std::vector<RecordedSpawn> spawns;
  std::vector<RecordedGrowth> growths;
  std::vector<RecordedLoss> losses;
  std::vector<RecordedRejection> rejections;
  std::vector<RecordedEnd> ends;
  std::string status;
  double probability = 0;
  double none = 0;
  std::string why;                  ///< the status is what it is; may be empty
  std::vector<std::string> sensor;  ///< where the drive does not agree with the sensor description
  HypothesisId best = {};
  std::vector<RecordedHypothesis> hypotheses;          ///< alive at the end of the update, best first
  std::vector<RecordedFinding> findings;               ///< about the best one
  std::vector<std::pair<std::string, double>> cpu_ms;  ///< per stage, in the order of the pipeline, "total" last
  std::optional<Pose2> truth;                          ///< T_map_base
};

}  // namespace opal
