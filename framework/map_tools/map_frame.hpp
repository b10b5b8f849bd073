#pragma once

#include "jsonld/json_ld.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace opal {

/// A JSON-LD document, and what messages call it.
struct NamedDocument {
  nlohmann::json content;
  std::string name;
};

/// The nodes of a map document that match a frame, as trees of the frame's shape (Hendrikx 2023, C.1.1; W3C JSON-LD 1.1
/// Framing). Both may use the context urn:opal:v1. The whole graph of the document is asked, words of other
/// vocabularies included; coordinates are in the `map` frame, metres, radians.
/// @throws MapError naming document or frame and the place in it: what maps to no IRI, what is no frame, a result
/// beyond what FrameOptions allows.
OPAL_EXPORT nlohmann::json framed_map(const NamedDocument& map, const NamedDocument& frame,
                                      const json_ld::FrameOptions& options = {});

/// How many nodes a framed document has at its top.
OPAL_EXPORT std::size_t matches_in(const nlohmann::json& framed);

}  // namespace opal
