#include "mcap_file.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>

namespace {

using namespace opal;
using namespace opal::recording_tests;

McapOptions small_chunks(const std::string& compression) {
  McapOptions options;
  options.compression = compression;
  options.chunk_bytes = 400;
  return options;
}

const char* any_compression() { return GENERATE("", "lz4", "zstd"); }

}  // namespace

TEST_CASE("what is written to an MCAP file is read from it, by time, whatever the compression") {
  const std::string compression = any_compression();
  CAPTURE(compression);
  const ReadFile read = read_file(two_topics(small_chunks(compression), 50));
  CHECK(read.defects.empty());
  CHECK(read.stamps == 100);
  REQUIRE(read.messages.size() == 100);
  CHECK(read.messages[0] == "front 0");
  CHECK(read.messages[1] == "rear 0");
  CHECK(read.messages[99] == "rear 49");
  REQUIRE(read.topics.size() == 2);
  CHECK(read.topics[0].name == "/front");
  CHECK(read.topics[0].type == "sensor_msgs/msg/LaserScan");
  CHECK(read.topics[0].wire == recording::Wire::cdr);
}

TEST_CASE("an MCAP file without messages is read as that") {
  const ReadFile read = read_file(two_topics({}, 0));
  CHECK(read.messages.empty());
  CHECK(read.defects.empty());
  CHECK(read.topics.size() == 2);
}

TEST_CASE("messages of overlapping chunks are walked by time") {
  std::ostringstream out;
  recording::McapWriter writer(out, "made.mcap", small_chunks("zstd"));
  const auto channel = writer.add_channel("/scan", writer.add_schema("a/msg/B", "ros2msg", ""), "cdr");
  for (const int second : {5, 1, 4, 2, 3}) {
    writer.write(channel, 0, second * 1'000'000'000LL, 0, bytes_of(std::to_string(second)));
    writer.flush();
  }
  writer.finish();
  CHECK(read_file(out.str()).messages == std::vector<std::string>{"1", "2", "3", "4", "5"});
}

TEST_CASE("wherever an MCAP file is cut, its whole messages are read and the cut is told") {
  const std::string compression = any_compression();
  CAPTURE(compression);
  const std::string whole = two_topics(small_chunks(compression), 30);
  const std::vector<std::string> all = read_file(whole).messages;
  std::size_t most = 0;
  for (std::size_t length = 8; length < whole.size(); ++length) {
    CAPTURE(length);
    const ReadFile cut = read_file(whole.substr(0, length));
    REQUIRE(cut.messages.size() <= all.size());
    REQUIRE(std::equal(cut.messages.begin(), cut.messages.end(), all.begin()));
    REQUIRE(cut.messages.size() >= most);  // more of the file never gives fewer messages
    REQUIRE_FALSE(cut.defects.empty());
    most = cut.messages.size();
  }
  CHECK(most == all.size());
}

TEST_CASE("a bit that changed in a chunk costs this chunk, is told, and no wrong message is read") {
  const std::string compression = any_compression();
  CAPTURE(compression);
  const std::string whole = two_topics(small_chunks(compression), 30);
  const std::vector<std::string> all = read_file(whole).messages;
  for (std::size_t at = 8; at < whole.size(); at += 3) {
    CAPTURE(at);
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    const ReadFile read = read_file(changed);
    for (const std::string& message : read.messages) REQUIRE(std::find(all.begin(), all.end(), message) != all.end());
    REQUIRE_FALSE((read.defects.empty() && read.messages.size() < all.size()));
    REQUIRE(read.messages.size() + 14 >= all.size());  // a chunk has at most so many
  }
}

TEST_CASE("a chunk with a wrong CRC names its place, what was found and what was expected") {
  std::string bytes = two_topics(small_chunks(""), 3);
  const std::size_t at = bytes.find("front 1");
  bytes[at + 6] = '9';
  const ReadFile read = read_file(bytes);
  CHECK(read.messages.empty());
  REQUIRE(read.defects.size() == 1);
  CHECK_THAT(read.defects.begin()->first, Catch::StartsWith("message in a damaged chunk at byte ") &&
                                              Catch::Contains("its CRC is ") && Catch::Contains(", expected "));
  CHECK(read.defects.begin()->second == 6);
}

TEST_CASE("what is no MCAP file is refused with its name") {
  for (const std::string& bytes : {std::string(), std::string("\x89MCAP0"), std::string(100, 'x')}) {
    CHECK_THROWS_AS(read_file(bytes), LogError);
    CHECK_THROWS_WITH(read_file(bytes), "made.mcap: byte 0: no MCAP magic number, expected an MCAP recording");
  }
  CHECK_THROWS_WITH(recording::read_mcap("/nowhere/a.mcap"),
                    "/nowhere/a.mcap: no such file, expected an MCAP recording");
}

TEST_CASE("a writer refuses a compression that MCAP does not have, and tells what cannot be written") {
  std::ostringstream out;
  CHECK_THROWS_WITH(recording::McapWriter(out, "a.mcap", small_chunks("gzip")),
                    "a.mcap: compression 'gzip', expected zstd, lz4 or nothing");
  std::ofstream full("/dev/full", std::ios::binary);
  recording::McapWriter writer(full, "full.mcap", {});
  CHECK_THROWS_WITH(writer.finish(), Catch::StartsWith("full.mcap: "));
}

TEST_CASE("a recorder that was killed leaves all chunks that it wrote") {
  std::ostringstream out;
  {
    recording::McapWriter writer(out, "made.mcap", small_chunks("zstd"));
    const auto channel = writer.add_channel("/scan", writer.add_schema("a/msg/B", "ros2msg", ""), "cdr");
    for (int i = 0; i < 25; ++i) writer.write(channel, 0, i * 100'000'000LL, 0, bytes_of(std::to_string(i)));
  }  // never finished
  const ReadFile read = read_file(out.str());
  CHECK(read.messages.size() >= 20);  // at most a second is lost
  REQUIRE(read.defects.size() == 1);
  CHECK_THAT(read.defects.begin()->first, Catch::Contains("without a footer"));
}
