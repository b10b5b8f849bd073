// MCAP files, whole or not.
#include "tests/system/fuzz/recording_file.hpp"

#include <opal/common/error.hpp>
#include <opal/recording/mcap_recording.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    walk_to_the_end(*opal::recording::read_mcap(stream_of(data, size), "fuzz.mcap"));
  } catch (const opal::LogError&) {
    return 0;
  }
  return 0;
}
