#include <opal/local_map/scan_matcher.hpp>

namespace opal {

ScanMatcher::~ScanMatcher() = default;

}  // namespace opal
