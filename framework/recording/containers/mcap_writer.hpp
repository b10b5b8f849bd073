#pragma once

#include <opal/recording/recording.hpp>

#include <iosfwd>

namespace opal::recording {

/// How an MCAP file is written.
struct McapOptions {
  std::string profile = "ros2";                ///< what kind of messages the channels have
  std::string compression = "zstd";            ///< "zstd", "lz4" or "" for none
  std::uint64_t chunk_bytes = 768 * 1024;      ///< a chunk is written when it has as many
  std::int64_t chunk_span_ns = 1'000'000'000;  ///< or when it spans so much time: what a crash may cost
};

/// Writes an MCAP file (https://mcap.dev/spec) with chunks, indices, statistics and CRCs. Messages are kept as they
/// are. A file that was not finished, because the program or the power failed, holds all chunks that were written:
/// readers find them without the summary.
class McapWriter {
 public:
  /// @param out  must outlive the writer; positions are counted from here, so it should be at the start of a file.
  /// @param name  what errors call the file.
  /// @param options  profile, compression and size of chunks.
  /// @throws ConfigError for a compression that MCAP does not have.
  McapWriter(std::ostream& out, const std::string& name, McapOptions options = {});
  /// Does not finish the file.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Adds a type of messages.
  /// @param type  "sensor_msgs/msg/LaserScan"
  /// @param encoding  of its definition: "ros2msg".
  /// @param text  its definition, may be empty.
  /// @return its number
  std::uint16_t add_schema(const std::string& type, const std::string& encoding, const std::string& text);
  /// Adds a topic.
  /// @param topic  "/scan"
  /// @param schema  number of its type.
  /// @param message_encoding  "cdr" or "ros1".
  /// @param metadata  for other readers, as the quality of service that was offered.
  /// @return its number
  std::uint16_t add_channel(const std::string& topic, std::uint16_t schema, const std::string& message_encoding,
                            const std::map<std::string, std::string>& metadata = {});
  /// Adds a message. @throws WriteError naming the file, if it cannot be written.
  void write(std::uint16_t channel, std::uint32_t sequence, std::int64_t recorded_ns, std::int64_t published_ns,
             Bytes data);
  /// Writes what is in hand as a chunk, and hands it to the operating system. @throws WriteError
  void flush();
  /// Writes the last chunk and the summary. Nothing may be written after it. @throws WriteError
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal::recording
