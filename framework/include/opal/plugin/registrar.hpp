#pragma once

#include <opal/local_map/scan_matcher.hpp>
#include <opal/localization/scoring/hypothesis_scorer.hpp>
#include <opal/map/map_importer.hpp>
#include <opal/map/map_store.hpp>
#include <opal/patterns/pattern_template.hpp>
#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/log_source.hpp>

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace opal {

/// What a type is called, and which feature types it works on. Detectors produce, patterns consume.
struct TypeInfo {
  std::string name;                   ///< prefixed IRI: "opal:LineDetector"
  std::vector<std::string> consumes;  ///< feature types; empty: any
  std::vector<std::string> produces;  ///< feature types
};

/// Makes one object from its options. All options are present, in range, and of the right type when it is called:
/// the registry has checked them against plugin.jsonld and filled in the defaults.
template <class T>
using Factory = std::function<std::unique_ptr<T>(const nlohmann::json& options)>;

/// What a plugin sees while it is loaded: one overload per kind.
class OPAL_EXPORT Registrar {
 public:
  virtual ~Registrar();
  /// Registers a type that finds features in scans.
  virtual void add(TypeInfo type, Factory<FeatureDetector> make) = 0;
  /// Registers a type that relates features to each other.
  virtual void add(TypeInfo type, Factory<PatternTemplate> make) = 0;
  /// Registers a type that judges hypotheses.
  virtual void add(TypeInfo type, Factory<HypothesisScorer> make) = 0;
  /// Registers a type that reads recorded logs.
  virtual void add(TypeInfo type, Factory<LogSource> make) = 0;
  /// Registers a type that makes maps of other sources.
  virtual void add(TypeInfo type, Factory<MapImporter> make) = 0;
  /// Registers a type that lays scans over each other.
  virtual void add(TypeInfo type, Factory<ScanMatcher> make) = 0;
  /// Registers a type that keeps maps in versions.
  virtual void add(TypeInfo type, Factory<MapStore> make) = 0;
};

}  // namespace opal
