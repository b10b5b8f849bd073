// Writes a file for another implementation to read: write_sample FILE COMPRESSION
#include "recording/containers/mcap_writer.hpp"

#include <fstream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ofstream file(argv[1], std::ios::binary);
  opal::recording::McapOptions options;
  options.compression = argv[2];
  options.chunk_bytes = 4000;
  opal::recording::McapWriter writer(file, argv[1], options);
  const auto schema = writer.add_schema("std_msgs/msg/String", "ros2msg", "string data");
  const auto a = writer.add_channel("/a", schema, "cdr", {{"offered_qos_profiles", "reliable"}});
  const auto b = writer.add_channel("/b", schema, "cdr");
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::string text = "message " + std::to_string(i);
    const std::int64_t stamp_ns = 1'700'000'000'000'000'000LL + 10'000'000LL * i;
    writer.write(i % 2 == 0 ? a : b, i, stamp_ns, stamp_ns, std::as_bytes(std::span(text)));
  }
  writer.finish();
}
