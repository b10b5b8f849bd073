#pragma once

#include <fmt/chrono.h>

#include <ctime>
#include <string>

namespace opal {

/// The time of day now: "2026-01-31T10:00:00Z" (ISO 8601, UTC, whole seconds).
inline std::string now_utc() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

}  // namespace opal
