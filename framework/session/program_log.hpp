#pragma once

namespace opal::session {

/// From now on, what the library and the session log goes to stderr, a line each: results on stdout stay by themselves.
void log_to_stderr();

}  // namespace opal::session
