#pragma once

#include <opal/sensing/scan.hpp>

namespace opal {

/// Puts the beams of a scan in the order that Scan promises.
void sort_by_bearing(Scan& scan);

}  // namespace opal
