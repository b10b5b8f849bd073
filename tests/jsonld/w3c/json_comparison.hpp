#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace opal::test {

/// Whether two expanded or flattened documents say the same: objects are unordered, arrays too except in
/// @list and in JSON literals, blank nodes may bear other labels.
bool same_document(const nlohmann::json& a, const nlohmann::json& b);

/// The first few places where they differ, for a reader.
std::string difference(const nlohmann::json& expected, const nlohmann::json& found);

}  // namespace opal::test
