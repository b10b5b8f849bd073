#pragma once

#include "viewer/reading/event_place.hpp"

#include <string_view>

namespace opal {

/// Parses one line of an event stream, strictly: UTF-8, no key twice, finite numbers, bounded depth.
/// @throws EventError "column N: what was found, what was expected".
Event parse_event(std::string_view line);

}  // namespace opal
