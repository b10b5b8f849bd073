#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace opal {

/// The JSON of a map document. @throws MapError.
nlohmann::json read_document(const std::string& path);
nlohmann::json parse_document(const std::string& text, const std::string& name);
/// The nodes of a document that uses Opal's context, words that nobody defined refused. @throws MapError naming the
/// source.
nlohmann::json flattened_document(const nlohmann::json& document, const std::string& source, bool keep_pointers);
/// The prefixes that the document's outermost context defines, beside those of Opal's.
std::map<std::string, std::string> prefixes_of(const nlohmann::json& document);

}  // namespace opal
