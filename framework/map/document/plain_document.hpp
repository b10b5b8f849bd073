#pragma once

#include "map/semantic_map_draft.hpp"

#include <opal/common/strict_json.hpp>

#include <functional>
#include <optional>
#include <string>

namespace opal {

/// Reads a document that is written as Opal writes maps: things in the building by the terms of Opal's context, each in
/// one place, with ids that have no prefix, and without a pattern layer.
/// @param name       of the document.
/// @param read_rest  makes a draft of the document without the things in the building.
/// @return the draft; none if the document is not plain or has a fault, so that the general reader has to look.
std::optional<MapDraft> read_plain_document(const std::string& text, const std::string& name,
                                            const std::function<MapDraft(const nlohmann::json& rest)>& read_rest,
                                            const JsonLimits& limits);

}  // namespace opal
