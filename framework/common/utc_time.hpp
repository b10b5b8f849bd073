#pragma once

#include <opal/common/export.hpp>

#include <string>

namespace opal {

/// The time of day now: "2026-01-31T10:00:00Z" (ISO 8601, UTC, whole seconds).
OPAL_EXPORT std::string now_utc();

}  // namespace opal
