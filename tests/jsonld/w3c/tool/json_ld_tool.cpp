// Prints what the JSON-LD processor makes of a document, for comparison with another processor:
//   json_ld_tool BASE DOCUMENT [FRAME]
#include <opal/common/strict_json.hpp>
#include "jsonld/json_ld.hpp"

#include <exception>
#include <iostream>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  try {
    opal::json_ld::Options options;
    options.base = argv[1];
    options.contexts["urn:opal:v1"] = opal::read_json(OPAL_SOURCE_DIR "/maps/context/opal.jsonld");
    const nlohmann::json document = opal::read_json(argv[2]);
    const bool framed = argc > 3;
    std::cout << (framed ? opal::json_ld::frame(document, opal::read_json(argv[3]), options)
                         : opal::json_ld::flatten(document, options));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
