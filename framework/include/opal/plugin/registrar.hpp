#pragma once

#include <opal/local_map/scan_matcher.hpp>
#include <opal/localization/scoring/hypothesis_scorer.hpp>
#include <opal/map/map_importer.hpp>
#include <opal/map/map_store.hpp>
#include <opal/patterns/pattern_template.hpp>
#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/log_source.hpp>

#include <nlohmann/json.hpp>

#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace opal {

/// What a type is called, and which feature types it works on. Detectors produce, patterns consume.
struct TypeInfo {
  std::string name;                        ///< prefixed IRI: "opal:LineDetector"
  std::vector<std::string> consumes = {};  ///< feature types; empty: any
  std::vector<std::string> produces = {};  ///< feature types
};

/// Makes one object from its options. All options are present, in range, and of the right type when it is called:
/// the registry has checked them against plugin.jsonld and filled in the defaults.
template <class T>
using Factory = std::function<std::unique_ptr<T>(const nlohmann::json& options)>;

/// Declared only, to find the interface of a class by overload resolution.
namespace interface_of {
FeatureDetector* find(const FeatureDetector&);    ///< finds features in scans
PatternTemplate* find(const PatternTemplate&);    ///< relates features to each other
HypothesisScorer* find(const HypothesisScorer&);  ///< judges hypotheses
LogSource* find(const LogSource&);                ///< reads recorded logs
MapImporter* find(const MapImporter&);            ///< makes maps of other sources
ScanMatcher* find(const ScanMatcher&);            ///< lays scans over each other
MapStore* find(const MapStore&);                  ///< keeps maps in versions
}  // namespace interface_of

/// The interface that a class of a plugin implements.
template <class T>
using InterfaceOf = std::remove_pointer_t<decltype(interface_of::find(std::declval<const T&>()))>;

/// Makes T(first..., options). No member of Registrar: all of an exported class leaves the plugin, and a plugin exports
/// one symbol.
template <class T, class... First>
Factory<InterfaceOf<T>> make_with(First... first) {
  return [first...](const nlohmann::json& options) { return std::make_unique<T>(first..., options); };
}
/// Makes T(read(options)).
template <class T, class Read>
Factory<InterfaceOf<T>> make_from(Read read) {
  return [read](const nlohmann::json& options) { return std::make_unique<T>(read(options)); };
}

/// What a plugin sees while it is loaded. `add<T>` registers a class by its interface; the other overloads, one per
/// kind, take any factory.
class OPAL_EXPORT Registrar {
 public:
  virtual ~Registrar();
  /// Registers a class that is made as T(first..., options).
  /// @param type   what it is called, and what it works on.
  /// @param first  what its constructor takes before the options.
  template <class T, class... First>
  requires std::constructible_from<T, const First&..., const nlohmann::json&>
  void add(TypeInfo type, First... first) { add(std::move(type), make_with<T>(std::move(first)...)); }
  /// Registers a class that takes its options in a form of its own: it is made as T(read(options)).
  /// @param type  what it is called, and what it works on.
  /// @param read  brings the options into that form.
  template <class T, std::invocable<const nlohmann::json&> Read>
  void add(TypeInfo type, Read read) {
    add(std::move(type), make_from<T>(std::move(read)));
  }
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
