// Whatever the bytes, reading them ends with a document or with an opal::Error.
#include <opal/json_ld.hpp>
#include <opal/strict_json.hpp>

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
  options.contexts["urn:c"] = {
      {"@context", {{"@vocab", "urn:v:"}, {"t", {{"@id", "urn:t"}, {"@context", "urn:c"}}}}}};
  options.contexts["urn:d"] = {{"@context", {"urn:e", "urn:e"}}};
  options.contexts["urn:e"] = {{"@context", {"urn:d", "urn:d"}}};
  options.contexts["urn:f"] = nullptr;
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    const auto document = opal::parse_json(std::string(data + 1, data + size), "input");
    const auto options = options_for(data[0]);
    opal::json_ld::expand(document, options);
    opal::json_ld::flatten(document, options);
  } catch (const opal::Error&) {
    return 0;
  }
  return 0;
}
