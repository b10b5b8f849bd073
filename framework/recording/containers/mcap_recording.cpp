#include <opal/common/error.hpp>
#include <opal/common/file_start.hpp>
#include <opal/recording/byte_reader.hpp>
#include <opal/recording/mcap_recording.hpp>
#include "recording/containers/mcap_reader.hpp"

#include <cstring>
#include <span>

namespace opal::recording {
namespace {

// Consecutive messages outside of chunks are read together.
constexpr std::uint64_t kLooseChunkBytes = 1 << 20;

}  // namespace

std::string byte_text(std::uint64_t offset) { return "byte " + std::to_string(offset); }

bool begins_as_mcap(Bytes bytes) {
  return bytes.size() >= kMcapMagic.size() && std::memcmp(bytes.data(), kMcapMagic.data(), kMcapMagic.size()) == 0;
}

void McapRecording::read() {
  if (!begins_as_mcap(file().read(0, kMcapMagic.size())))
    throw LogError(name_ + ": byte 0: no MCAP magic number, expected an MCAP recording");
  read_footer();
  walk_records();
  complete();
  if (stated_messages_ && *stated_messages_ != message_count())
    count("the summary states " + std::to_string(*stated_messages_) + " messages, found " +
          std::to_string(message_count()));
}

std::uint64_t McapRecording::next_known_start(std::uint64_t position) const {
  const auto next = chunk_starts_.upper_bound(position);
  return next == chunk_starts_.end() ? data_end_ : std::min(*next, data_end_);
}

/// @return nullopt where there is no record that ends before the next one that the summary knows.
std::optional<RecordPlace> McapRecording::record_at(std::uint64_t position) {
  const std::vector<std::byte> bytes = file().read(position, kMcapRecordStart);
  ByteReader start(bytes);
  const auto op = start.number<std::uint8_t>();
  const auto length = start.number<std::uint64_t>();
  const std::uint64_t content = position + kMcapRecordStart;
  // Operation codes from 0x80 on are those of users.
  const bool is_known = op != 0 && (op <= static_cast<std::uint8_t>(McapOp::data_end) || op >= 0x80);
  if (!start.ok() || !is_known) return std::nullopt;
  const std::uint64_t limit = next_known_start(position);
  if (content > limit || length > limit - content) {
    // A chunk that the end of the file cuts has whole messages at its beginning.
    const bool is_last = limit == file().size() && op == static_cast<std::uint8_t>(McapOp::chunk);
    if (!is_last) return std::nullopt;
    return RecordPlace{McapOp::chunk, content, content + std::min(length, std::uint64_t{1} << 62)};
  }
  return RecordPlace{static_cast<McapOp>(op), content, content + length};
}

void McapRecording::walk_records() {
  std::uint64_t position = kMcapMagic.size();
  while (position < data_end_ && !ended_) {
    const std::optional<RecordPlace> record = record_at(position);
    const std::uint64_t next = record ? record->end : next_known_start(position);
    if (record && !walk_record(*record)) return;
    if (!record) {
      if (indexed_chunk_) forget_index(*indexed_chunk_);  // the rest of it is damaged or cut
      indexed_chunk_.reset();
      loose_chunk_.reset();
      count("no whole record at " + byte_text(position) + ": " + std::to_string(next - position) +
            " bytes are left out, expected a record of MCAP");
    }
    position = next;
  }
  if (indexed_chunk_ && !ended_ && chunk_starts_.empty()) forget_index(*indexed_chunk_);  // the index may be cut
  if (!is_closed_)
    count("the file ends at " + byte_text(file().size()) + " without a footer: it was cut, or its recorder was killed");
}

/// @return false at the end of the file.
bool McapRecording::walk_record(const RecordPlace& record) {
  if (record.op != McapOp::message_index) indexed_chunk_.reset();
  if (record.op != McapOp::message) loose_chunk_.reset();
  switch (record.op) {
    case McapOp::chunk: begin_chunk(record); break;
    case McapOp::message_index: read_index(record); break;
    case McapOp::message: add_loose_message(record); break;
    case McapOp::data_end: check_data_crc(record); [[fallthrough]];
    case McapOp::footer: ended_ = true; break;
    case McapOp::schema:
    case McapOp::channel: describe(record.op, content_of(record)); break;
    default: break;  // header, attachments, metadata
  }
  if (record.end <= file().size()) return true;
  count("the file ends at " + byte_text(file().size()) + " in the chunk at " +
        byte_text(record.content - kMcapRecordStart) + ", expected " + std::to_string(record.end) +
        " bytes; its whole messages are read");
  return false;
}

void McapRecording::begin_chunk(const RecordPlace& record) {
  constexpr std::uint64_t kMostStart = 256;  // names of compressions are short
  const std::vector<std::byte> bytes = file().read(record.content, std::min(kMostStart, record.end - record.content));
  ByteReader start(bytes);
  Chunk chunk;
  start.bytes(2 * sizeof(std::uint64_t));  // times of the first and the last message
  chunk.whole_bytes = start.number<std::uint64_t>();
  chunk.crc = start.number<std::uint32_t>();
  chunk.compression = start.text();
  chunk.stored_bytes = start.number<std::uint64_t>();
  chunk.offset = record.content + (bytes.size() - start.rest().size());
  chunk.is_cut = record.end > file().size();
  if (!start.ok() || (!chunk.is_cut && chunk.stored_bytes > record.end - chunk.offset))
    return count("chunk at " + byte_text(record.content - kMcapRecordStart) + ": its sizes do not fit together");
  if (chunk.is_cut) chunk.stored_bytes = file().size() - std::min(chunk.offset, file().size());
  indexed_chunk_ = add_chunk(chunk);
}

/// The indices of a chunk's channels stand behind it.
void McapRecording::read_index(const RecordPlace& record) {
  if (!indexed_chunk_) return;
  const std::vector<std::byte> content = content_of(record);
  ByteReader index(content);
  MessagePlace place;
  place.chunk = *indexed_chunk_;
  place.channel = index.number<std::uint16_t>();
  ByteReader entries(index.bytes(index.number<std::uint32_t>()));
  while (!entries.rest().empty()) {
    place.recorded_ns = static_cast<std::int64_t>(entries.number<std::uint64_t>());
    place.offset = entries.number<std::uint64_t>();
    if (entries.ok()) add_place(place);
    if (!entries.ok()) break;
  }
  mark_indexed(*indexed_chunk_);
  const bool is_whole = index.ok() && entries.ok();
  if (is_whole && index.rest().empty()) return;
  forget_index(*indexed_chunk_);
  if (!is_whole)
    count("damaged index at " + byte_text(record.content - kMcapRecordStart) + ": the chunk before it is read instead");
  indexed_chunk_.reset();
}

/// Chunks have CRCs of their own. The one of all data matters where messages stand outside of chunks.
void McapRecording::check_data_crc(const RecordPlace& data_end) {
  const std::vector<std::byte> content = content_of(data_end);
  const auto expected = ByteReader(content).number<std::uint32_t>();
  const auto is_loose = [](const Chunk& chunk) { return chunk.whole_bytes == chunk.stored_bytes && chunk.crc == 0; };
  if (expected == 0 || chunks().empty() || !std::all_of(chunks().begin(), chunks().end(), is_loose)) return;
  const std::uint64_t end = data_end.content - kMcapRecordStart;
  std::uint32_t found = 0;
  for (std::uint64_t position = 0; position < end; position += kLooseChunkBytes)
    found = crc32_of(file().read(position, std::min(kLooseChunkBytes, end - position)), found);
  if (found != expected)
    count("data before " + byte_text(end) + ": their CRC is " + std::to_string(found) + ", expected " +
          std::to_string(expected) + "; which message is damaged is not known");
}

void McapRecording::add_loose_message(const RecordPlace& record) {
  const std::uint64_t start = record.content - kMcapRecordStart;
  const auto fits = [&](const Chunk& chunk) { return record.end - chunk.offset <= kLooseChunkBytes; };
  if (!loose_chunk_ || !fits(chunks()[*loose_chunk_])) loose_chunk_ = add_chunk({start, 0, 0, "", 0, false, false});
  extend_last_chunk(record.end);
}

/// @return what is damaged
std::string McapRecording::read_content(std::uint32_t chunk, Bytes whole) {
  const bool is_indexed = chunks()[chunk].is_indexed;
  ByteReader records(whole);
  while (!records.rest().empty()) {
    MessagePlace place;
    place.chunk = chunk;
    place.offset = whole.size() - records.rest().size();
    const auto op = static_cast<McapOp>(records.number<std::uint8_t>());
    const Bytes content = records.bytes(records.number<std::uint64_t>());
    if (!records.ok()) return "no whole record " + std::to_string(place.offset) + " bytes";
    describe(op, content);
    if (op != McapOp::message || is_indexed) continue;
    ByteReader message(content);
    place.channel = message.number<std::uint16_t>();
    message.number<std::uint32_t>();  // sequence
    place.recorded_ns = static_cast<std::int64_t>(message.number<std::uint64_t>());
    if (message.ok() && content.size() >= kMcapMessageStart) add_place(place);
  }
  return "";
}

Bytes McapRecording::message_at(const MessagePlace& place, Bytes whole) const {
  ByteReader record(whole);
  record.bytes(place.offset);
  const auto op = record.number<std::uint8_t>();
  ByteReader message(record.bytes(record.number<std::uint64_t>()));
  const auto channel = message.number<std::uint16_t>();
  message.bytes(sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t));  // sequence, two times
  const bool is_there = op == static_cast<std::uint8_t>(McapOp::message) && channel == place.channel;
  if (!is_there || !record.ok() || !message.ok())
    throw Damage("no message of this topic where its index leads, expected one");
  return message.rest();
}

namespace {

std::unique_ptr<Recording> read_all_of(RecordFile file, const std::string& name) {
  auto recording = std::make_unique<McapRecording>(std::move(file), name);
  recording->read();
  return recording;
}

}  // namespace

bool is_mcap(const std::string& path) {
  const std::string start = first_bytes(path, kMcapMagic.size());
  return begins_as_mcap(std::as_bytes(std::span(start)));
}

std::unique_ptr<Recording> read_mcap(const std::string& path) {
  return read_all_of(open_record_file(path, "an MCAP recording"), path);
}

std::unique_ptr<Recording> read_mcap(std::unique_ptr<std::istream> stream, const std::string& name) {
  return read_all_of(RecordFile(std::move(stream)), name);
}

}  // namespace opal::recording
