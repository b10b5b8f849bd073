// Whatever the bytes, decisions about proposals are read or refused with an opal::Error; written and read again, they
// say the same.
#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "review/decisions.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  opal::Decisions decisions;
  try {
    decisions =
        opal::decisions_from(opal::parse_json(std::string(reinterpret_cast<const char*>(data), size), "fuzz"), "fuzz");
  } catch (const opal::Error&) {
    return 0;
  }
  const std::string written = opal::to_json(decisions).dump();
  if (opal::to_json(opal::decisions_from(opal::parse_json(written, "again"), "again")).dump() != written) std::abort();
  return 0;
}
