// The key functions of the interfaces: one vtable and one typeinfo each, in libopal.so.
#include <opal/sensing/feature_detector.hpp>
#include <opal/sensing/log_source.hpp>

namespace opal {

FeatureDetector::~FeatureDetector() = default;
LogReader::~LogReader() = default;
LogSource::~LogSource() = default;

}  // namespace opal
