// Whatever the bytes, reading them ends with a document or with an opal::Error.
#include <opal/common/strict_json.hpp>
#include "jsonld/json_ld.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace {

/// Contexts that a document may name: plain, in a circle, and broken.
opal::json_ld::Options options_for(std::uint8_t choice) {
  opal::json_ld::Options options;
  options.base = choice & 1 ? "http://example.org/a/b" : "";
  options.keep_pointers = choice & 2;
  options.reject_unknown_terms = choice & 4;
  options.contexts["urn:c"] = {{"@context", {{"@vocab", "urn:v:"}, {"t", {{"@id", "urn:t"}, {"@context", "urn:c"}}}}}};
  options.contexts["urn:d"] = {{"@context", {"urn:e", "urn:e"}}};
  options.contexts["urn:e"] = {{"@context", {"urn:d", "urn:d"}}};
  options.contexts["urn:f"] = nullptr;
  return options;
}

/// An array of two is a document and a frame.
void ask(const nlohmann::json& document, const nlohmann::json& frame, const opal::json_ld::Options& options,
         std::uint8_t choice) {
  opal::json_ld::FrameOptions asked;
  asked.bytes = 1u << 20;
  asked.embed = choice & 8 ? "@always" : "@once";
  asked.omit_default = choice & 16;
  asked.prune_blank_nodes = choice & 32;
  opal::json_ld::frame(document, frame, options, asked);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    const auto document = opal::parse_json(std::string(data + 1, data + size), "input");
    const auto options = options_for(data[0]);
    opal::json_ld::expand(document, options);
    opal::json_ld::flatten(document, options);
    if (document.is_object()) opal::json_ld::compact(document, document.value("@context", nlohmann::json()), options);
    if (document.is_array() && document.size() == 2) ask(document[0], document[1], options, data[0]);
  } catch (const opal::Error&) {
    return 0;
  }
  return 0;
}
