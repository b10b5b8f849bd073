// Bags of ROS 1, whole or not. Their reader is compiled in: it is not part of a library.
#include "plugins/ros1_bag/bag_recording.cpp"  // NOLINT(bugprone-suspicious-include): see above
#include "plugins/ros1_bag/bzip2_chunk.cpp"    // NOLINT(bugprone-suspicious-include): see above
#include "tests/system/fuzz/recording_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    walk_to_the_end(*opal::ros1_bag::read_bag(stream_of(data, size), "fuzz.bag"));
  } catch (const opal::LogError&) {
    return 0;
  }
  return 0;
}
