#pragma once

#include <opal/common/export.hpp>

#include <functional>
#include <string_view>

namespace opal {

/// Takes a line of text without its end. It is called by one thread at a time, and must not call Opal.
using WarningSink = std::function<void(std::string_view line)>;

/// Says where the warnings of this process go. Until it is called, they go to stderr, a line each.
/// @param sink  empty: stderr again.
OPAL_EXPORT void set_warning_sink(WarningSink sink);

/// For the library and its plugins: tells whoever runs the program what goes another way than asked, and is no Error.
/// Any thread may call it. A std::exception that the sink throws is told on stderr.
/// @param line  who warns, and of what; without an end of line.
OPAL_EXPORT void warn(std::string_view line);

}  // namespace opal
