// The key functions of the plugin interfaces: one vtable and one typeinfo each, in libopal.so.
#include <opal/plugin/feature_detector.hpp>
#include <opal/plugin/hypothesis_scorer.hpp>
#include <opal/plugin/log_source.hpp>
#include <opal/plugin/map_importer.hpp>
#include <opal/plugin/map_store.hpp>
#include <opal/plugin/pattern_template.hpp>
#include <opal/plugin/registrar.hpp>
#include <opal/plugin/scan_matcher.hpp>

namespace opal {

FeatureDetector::~FeatureDetector() = default;
PatternTemplate::~PatternTemplate() = default;
HypothesisScorer::~HypothesisScorer() = default;
bool HypothesisScorer::judges_associations() const { return true; }
std::vector<Finding> HypothesisScorer::explain(const Hypothesis&, const Observation&, const MapView&) const { return {}; }
LogReader::~LogReader() = default;
LogSource::~LogSource() = default;
MapImporter::~MapImporter() = default;
std::vector<Storey> MapImporter::storeys(const std::string&) const { return {}; }
ScanMatcher::~ScanMatcher() = default;
MapStore::~MapStore() = default;
StoreError::~StoreError() = default;
StoreUnreachable::~StoreUnreachable() = default;
StoreConflict::~StoreConflict() = default;
Registrar::~Registrar() = default;

}  // namespace opal
