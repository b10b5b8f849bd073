#pragma once

#include <opal/sensing/log_contents.hpp>

#include <nlohmann/json.hpp>

namespace opal::cli {

/// What a log holds, in words and tables.
std::string contents_text(const LogContents& contents);
/// The same for programs. Lengths in m, angles in rad, times in s.
nlohmann::ordered_json contents_json(const LogContents& contents);

}  // namespace opal::cli
