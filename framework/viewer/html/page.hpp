#pragma once

#include "viewer/encoding/packed_run.hpp"

#include <string>
#include <vector>

namespace opal {

/// The largest file that is written for a browser to open.
constexpr std::size_t kLargestPage = 15'000'000;
/// Characters of data that each of so many runs may take.
std::size_t room_for_data(std::size_t runs);

/// The page that shows these runs: HTML text, self-contained. Nothing in a run becomes markup or script.
std::string page_of(const std::vector<PackedRun>& runs);

/// The same page for a run that goes on: it gets its records from this path of the server that it came from.
std::string live_page(const std::string& events_path);

}  // namespace opal
