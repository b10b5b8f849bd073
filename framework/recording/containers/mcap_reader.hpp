#pragma once

#include <opal/recording/chunked_recording.hpp>
#include "recording/containers/mcap_format.hpp"

namespace opal::recording {

/// Whether bytes begin with MCAP's magic number.
bool begins_as_mcap(Bytes bytes);
/// "byte 17"
std::string byte_text(std::uint64_t offset);

/// Where a record stands in the file.
struct RecordPlace {
  McapOp op;
  std::uint64_t content = 0;  // its first byte behind op and length
  std::uint64_t end = 0;
};

/// Reads an MCAP file: first the summary at its end, if it is whole, then all records but not what chunks hold.
class McapRecording final : public ChunkedRecording {
 public:
  McapRecording(RecordFile file, std::string name) : ChunkedRecording(std::move(file)), name_(std::move(name)) {}

  /// Finds all messages. @throws LogError if it is no MCAP file.
  void read();
  Bytes message_at(const MessagePlace& place, Bytes whole) const override;

 protected:
  Unpacked unpack(const Chunk& chunk, Bytes packed) const override {
    return unpack_chunk(chunk.compression, packed, chunk.whole_bytes);
  }
  std::string read_content(std::uint32_t chunk, Bytes whole) override;

 private:
  void read_footer();
  void read_summary(std::uint64_t start, std::uint64_t end);
  void walk_records();
  bool walk_record(const RecordPlace& record);
  std::uint64_t next_known_start(std::uint64_t position) const;
  std::optional<RecordPlace> record_at(std::uint64_t position);
  void describe(McapOp op, Bytes content);
  void add_schema(Bytes content);
  void add_described_channel(Bytes content);
  void begin_chunk(const RecordPlace& record);
  void read_index(const RecordPlace& record);
  void check_data_crc(const RecordPlace& data_end);
  void add_loose_message(const RecordPlace& record);
  std::vector<std::byte> content_of(const RecordPlace& record) const {
    return file().read(record.content, record.end - record.content);
  }

  std::string name_;
  std::map<std::uint16_t, std::string> schemas_;  // names of types
  std::set<std::uint64_t> chunk_starts_;          // by the summary
  std::uint64_t data_end_ = 0;                    // of what the walk reads
  std::optional<std::uint32_t> indexed_chunk_;    // whose index is being read
  std::optional<std::uint32_t> loose_chunk_;      // of messages outside of chunks
  std::optional<std::uint64_t> stated_messages_;  // by the summary
  bool is_closed_ = false;                        // it ends with a footer
  bool ended_ = false;                            // by a DataEnd or a footer
};

}  // namespace opal::recording
