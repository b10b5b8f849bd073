// Whatever the bytes, the evidence of a drive is read or refused with an opal::Error; written and read again, it says
// the same.
#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "learning/drive_evidence.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  opal::DriveEvidence evidence;
  try {
    evidence = opal::drive_evidence_from(
        opal::parse_json(std::string(reinterpret_cast<const char*>(data), size), "fuzz"), "fuzz");
  } catch (const opal::Error&) {
    return 0;
  }
  const std::string written = opal::to_json(evidence).dump();
  if (opal::to_json(opal::drive_evidence_from(opal::parse_json(written, "again"), "again")).dump() != written)
    std::abort();
  return 0;
}
