#pragma once

#include <opal/common/geometry.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What `run` and `map` say about a whole recording. Frame: `map` [m, rad].
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
    int object = -1;  ///< position in objects
    std::string type;
    bool perceivable = true;  ///< by the run's sensor; only such features take part in associations
    Geometry geometry;
  };
  struct Pattern {
    std::string id, pattern_template;
    std::vector<int> features;  ///< positions in features
  };
  std::string map_name;
  std::vector<Object> objects;
  std::vector<Feature> features;
  std::vector<Pattern> patterns;
};

/// One recorded association: local feature -> position in RunHeader::features, or -1 for "not on the map".
struct RecordedPair {
  int local_feature = -1;
  int map_feature = -1;
};

struct RecordedTerm {
  std::string scorer, term;
  double value = 0;
};

/// What a scorer saw for or against a hypothesis. Frame of `line`: `map` [m].
struct RecordedFinding {
  std::string scorer, words;
  int map_feature = -1;     ///< position in RunHeader::features; -1: none
  std::vector<Point> line;  ///< two points, or empty
};

struct RecordedLocalFeature {
  int id = -1;
  std::string type;
  bool stable = false;
  int measurements = 0;
  Geometry geometry;  ///< frame `local`
};

struct RecordedHypothesis {
  int id = -1;
  Pose2 T_map_base;
  double log_likelihood = 0;  ///< [nat]
  double scan_nat = 0;        ///< of the newest scan
  double probability = 0;
  std::vector<RecordedTerm> scores;
};

struct RecordedSpawn {
  int id = -1;
  int parent = -1;  ///< -1: from a search
  std::string pattern_template;
  Pose2 T_map_base;
  double log_likelihood = 0;
  std::vector<RecordedPair> pairs;
};

struct RecordedGrowth {
  int hypothesis = -1;
  std::vector<RecordedPair> pairs;
};

struct RecordedLoss {
  int hypothesis = -1;
  std::vector<int> local_features;
  std::string reason;
};

struct RecordedRejection {
  int hypothesis = -1;  ///< the parent
  std::vector<RecordedPair> pairs;
  std::string reason;
};

struct RecordedEnd {
  int id = -1;
  std::string reason;
  int merged_into = -1;
  Pose2 T_map_base;
  double log_likelihood = 0, scan_nat = 0;
  std::vector<RecordedTerm> scores;
  std::vector<RecordedFinding> findings;
};

struct RecordedSearch {
  struct Lookup {
    std::string pattern_template;
    std::vector<int> local_features;
    int candidates = 0;
  };
  struct Rejected {
    std::string pattern_template;
    Pose2 T_map_base;
    std::vector<RecordedPair> pairs;
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
  int keyframe = 0;
  double stamp_s = 0;
  double time_s = 0;                  ///< since the first update of the time line
  std::optional<std::string> starts;  ///< name of the time line that begins here
  Pose2 T_local_base;
  bool scan_match = false;
  std::vector<Point> scan;        ///< base_link
  std::vector<Point> free_space;  ///< base_link
  std::vector<RecordedLocalFeature> changed;
  std::vector<int> gone;
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
  int best = -1;
  std::vector<RecordedHypothesis> hypotheses;          ///< alive at the end of the update, best first
  std::vector<RecordedFinding> findings;               ///< about the best one
  std::vector<std::pair<std::string, double>> cpu_ms;  ///< per stage, in the order of the pipeline, "total" last
  std::optional<Pose2> truth;                          ///< T_map_base
};

}  // namespace opal
