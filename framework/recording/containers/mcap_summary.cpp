#include <opal/recording/byte_reader.hpp>
#include "recording/containers/mcap_reader.hpp"

namespace opal::recording {

/// A file that was closed ends with a footer and the magic number. The summary before it repeats all channels, and
/// tells where chunks are.
void McapRecording::read_footer() {
  data_end_ = file().size();
  constexpr std::size_t kTail = kMcapRecordStart + kMcapFooterBytes + kMcapMagic.size();
  if (file().size() < kTail + kMcapMagic.size()) return;
  const std::uint64_t footer_at = file().size() - kTail;
  const std::vector<std::byte> tail = file().read(footer_at, kTail);
  ByteReader footer(tail);
  const bool is_footer = footer.number<std::uint8_t>() == static_cast<std::uint8_t>(McapOp::footer) &&
                         footer.number<std::uint64_t>() == kMcapFooterBytes;
  if (!is_footer || !begins_as_mcap(Bytes(tail).last(kMcapMagic.size()))) return;
  is_closed_ = true;
  const auto summary_start = footer.number<std::uint64_t>();
  footer.number<std::uint64_t>();  // where its own index is
  const auto crc = footer.number<std::uint32_t>();
  if (summary_start == 0 || summary_start >= footer_at) return;
  const std::vector<std::byte> summary = file().read(summary_start, footer_at + kTail - summary_start);
  const std::size_t covered = summary.size() - kMcapMagic.size() - sizeof crc;
  const std::uint32_t found = crc == 0 ? 0 : crc32_of(Bytes(summary).first(covered));
  if (found == crc) return read_summary(summary_start, footer_at);
  count("summary at " + byte_text(summary_start) + ": its CRC is " + std::to_string(found) + ", expected " +
        std::to_string(crc) + "; it is not used");
}

void McapRecording::read_summary(std::uint64_t start, std::uint64_t end) {
  data_end_ = end;
  for (std::uint64_t position = start; position < end;) {
    const std::optional<RecordPlace> record = record_at(position);
    if (!record) break;
    const std::vector<std::byte> content = content_of(*record);
    describe(record->op, content);
    if (record->op == McapOp::statistics) stated_messages_ = ByteReader(content).number<std::uint64_t>();
    ByteReader index(content);
    index.bytes(2 * sizeof(std::uint64_t));  // times
    if (record->op == McapOp::chunk_index) chunk_starts_.insert(index.number<std::uint64_t>());
    position = record->end;
  }
  data_end_ = start;
}

void McapRecording::describe(McapOp op, Bytes content) {
  if (op == McapOp::schema) add_schema(content);
  if (op == McapOp::channel) add_described_channel(content);
}

void McapRecording::add_schema(Bytes content) {
  ByteReader schema(content);
  const auto id = schema.number<std::uint16_t>();
  const std::string type = schema.text();
  if (schema.ok()) schemas_.emplace(id, type);
}

void McapRecording::add_described_channel(Bytes content) {
  ByteReader channel(content);
  const auto id = channel.number<std::uint16_t>();
  const auto schema = schemas_.find(channel.number<std::uint16_t>());
  Topic topic;
  topic.name = channel.text();
  const std::string encoding = channel.text();
  topic.type = schema == schemas_.end() ? "" : schema->second;
  topic.wire = encoding == "cdr" ? Wire::cdr : encoding == "ros1" ? Wire::ros1 : Wire::other;
  if (channel.ok()) add_channel(id, topic);
}

}  // namespace opal::recording
