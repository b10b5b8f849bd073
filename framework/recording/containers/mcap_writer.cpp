#include "recording/containers/mcap_writer.hpp"

#include <opal/common/error.hpp>
#include <opal/recording/chunk_codec.hpp>
#include "common/write_error.hpp"
#include "recording/containers/mcap_format.hpp"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <ostream>

namespace opal::recording {
namespace {

/// Little-endian numbers, texts and maps, one after the other.
class ByteWriter {
 public:
  template <class Integer>
  ByteWriter& number(Integer value) {
    for (std::size_t i = 0; i < sizeof value; ++i)
      bytes_.push_back(static_cast<std::byte>(static_cast<std::uint64_t>(value) >> (8 * i)));
    return *this;
  }
  ByteWriter& raw(Bytes bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  ByteWriter& text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size()));
    return raw(std::as_bytes(std::span(text)));
  }
  /// Something after its length of four bytes.
  ByteWriter& sized(const ByteWriter& content) {
    number(static_cast<std::uint32_t>(content.size()));
    return raw(content.bytes());
  }
  ByteWriter& record(McapOp op, const ByteWriter& content) {
    number(static_cast<std::uint8_t>(op)).number(static_cast<std::uint64_t>(content.size()));
    return raw(content.bytes());
  }
  Bytes bytes() const { return bytes_; }
  std::size_t size() const { return bytes_.size(); }
  void clear() { bytes_.clear(); }

 private:
  std::vector<std::byte> bytes_;
};

struct IndexEntry {
  std::int64_t recorded_ns;
  std::uint64_t offset;
};

struct TimeSpan {
  std::int64_t first_ns = std::numeric_limits<std::int64_t>::max();
  std::int64_t last_ns = 0;
  void add(std::int64_t ns) {
    first_ns = std::min(first_ns, ns);
    last_ns = std::max(last_ns, ns);
  }
  /// MCAP has 0 for none.
  std::int64_t first() const { return std::min(first_ns, last_ns); }
};

/// A group of records in the summary.
struct SummaryGroup {
  McapOp op;
  ByteWriter records;
};

}  // namespace

struct McapWriter::State {
  State(std::ostream& stream, std::string file_name, McapOptions how)
      : out(stream), name(std::move(file_name)), options(std::move(how)) {}

  std::ostream& out;
  std::string name;
  McapOptions options;
  std::uint64_t position = 0;
  std::uint32_t data_crc = 0;

  ByteWriter chunk;  // records, not yet packed
  TimeSpan chunk_span;
  std::map<std::uint16_t, std::vector<IndexEntry>> chunk_index;  // by channel
  ByteWriter schemas, channels, chunk_indices;                   // for the summary
  TimeSpan span;
  std::map<std::uint16_t, std::uint64_t> messages;  // by channel
  std::uint16_t schema_count = 0;
  std::uint32_t chunk_count = 0;

  void put(Bytes bytes) {
    errno = 0;
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out) throw WriteError(name, errno != 0 ? errno : EIO);
    position += bytes.size();
  }
  void put_data(Bytes bytes) {
    put(bytes);
    data_crc = crc32_of(bytes, data_crc);
  }
  void put_chunk();
  ByteWriter put_index();
  ByteWriter statistics() const;
  void put_summary();
};

McapWriter::McapWriter(std::ostream& out, const std::string& name, McapOptions options)
    : state_(std::make_unique<State>(out, name, std::move(options))) {
  const std::string& compression = state_->options.compression;
  if (!compression.empty() && compression != "zstd" && compression != "lz4")
    throw ConfigError(name + ": compression '" + compression + "', expected zstd, lz4 or nothing");
  state_->put_data(std::as_bytes(std::span(kMcapMagic)));
  ByteWriter header, record;
  header.text(state_->options.profile).text("opal");
  state_->put_data(record.record(McapOp::header, header).bytes());
}

McapWriter::~McapWriter() = default;

std::uint16_t McapWriter::add_schema(const std::string& type, const std::string& encoding, const std::string& text) {
  const auto id = ++state_->schema_count;
  ByteWriter schema, record;
  schema.number(id).text(type).text(encoding).text(text);
  record.record(McapOp::schema, schema);
  state_->schemas.raw(record.bytes());
  state_->chunk.raw(record.bytes());
  return id;
}

std::uint16_t McapWriter::add_channel(const std::string& topic, std::uint16_t schema,
                                      const std::string& message_encoding,
                                      const std::map<std::string, std::string>& metadata) {
  const auto id = static_cast<std::uint16_t>(state_->messages.size());
  state_->messages[id] = 0;
  ByteWriter pairs, channel, record;
  for (const auto& [key, value] : metadata) pairs.text(key).text(value);
  channel.number(id).number(schema).text(topic).text(message_encoding).sized(pairs);
  record.record(McapOp::channel, channel);
  state_->channels.raw(record.bytes());
  state_->chunk.raw(record.bytes());
  return id;
}

void McapWriter::write(std::uint16_t channel, std::uint32_t sequence, std::int64_t recorded_ns,
                       std::int64_t published_ns, Bytes data) {
  State& state = *state_;
  const std::uint64_t offset = state.chunk.size();
  state.chunk.number(static_cast<std::uint8_t>(McapOp::message))
      .number(static_cast<std::uint64_t>(kMcapMessageStart + data.size()))
      .number(channel)
      .number(sequence)
      .number(recorded_ns)
      .number(published_ns)
      .raw(data);
  state.chunk_index[channel].push_back({recorded_ns, offset});
  state.chunk_span.add(recorded_ns);
  state.span.add(recorded_ns);
  ++state.messages[channel];
  const bool spans_enough = state.chunk_span.last_ns - state.chunk_span.first_ns >= state.options.chunk_span_ns;
  if (spans_enough || state.chunk.size() >= state.options.chunk_bytes) flush();
}

void McapWriter::flush() {
  if (state_->chunk.size() > 0) state_->put_chunk();
  errno = 0;
  if (!state_->out.flush()) throw WriteError(state_->name, errno != 0 ? errno : EIO);
}

/// A chunk with the indices of its channels behind it.
void McapWriter::State::put_chunk() {
  const std::vector<std::byte> packed = pack_chunk(options.compression, chunk.bytes());
  ByteWriter content, record;
  content.number(chunk_span.first()).number(chunk_span.last_ns).number(std::uint64_t{chunk.size()});
  content.number(crc32_of(chunk.bytes())).text(options.compression).number(std::uint64_t{packed.size()}).raw(packed);
  const std::uint64_t start = position, length = content.size() + kMcapRecordStart;
  put_data(record.record(McapOp::chunk, content).bytes());
  const std::uint64_t index_start = position;
  const ByteWriter offsets = put_index();
  ByteWriter index;
  index.number(chunk_span.first()).number(chunk_span.last_ns).number(start).number(length).sized(offsets);
  index.number(position - index_start).text(options.compression);
  index.number(std::uint64_t{packed.size()}).number(std::uint64_t{chunk.size()});
  chunk_indices.record(McapOp::chunk_index, index);
  ++chunk_count;
  chunk.clear();
  chunk_index.clear();
  chunk_span = {};
}

/// @return where the index of each channel is
ByteWriter McapWriter::State::put_index() {
  ByteWriter offsets;
  for (const auto& [channel, entries] : chunk_index) {
    ByteWriter list, index, record;
    for (const IndexEntry& entry : entries) list.number(entry.recorded_ns).number(entry.offset);
    index.number(channel).sized(list);
    offsets.number(channel).number(position);
    put_data(record.record(McapOp::message_index, index).bytes());
  }
  return offsets;
}

ByteWriter McapWriter::State::statistics() const {
  ByteWriter counts, statistics;
  std::uint64_t all = 0;
  for (const auto& [channel, count] : messages) {
    all += count;
    if (count > 0) counts.number(channel).number(count);
  }
  statistics.number(all).number(schema_count).number(static_cast<std::uint32_t>(messages.size()));
  statistics.number(std::uint32_t{0}).number(std::uint32_t{0}).number(chunk_count);  // no attachments, no metadata
  return statistics.number(span.first()).number(span.last_ns).sized(counts);
}

void McapWriter::State::put_summary() {
  const std::uint64_t summary_start = position;
  ByteWriter summary, offsets, statistic;
  statistic.record(McapOp::statistics, statistics());
  const SummaryGroup groups[] = {{McapOp::schema, schemas},
                                 {McapOp::channel, channels},
                                 {McapOp::statistics, statistic},
                                 {McapOp::chunk_index, chunk_indices}};
  for (const SummaryGroup& group : groups) {
    if (group.records.size() == 0) continue;
    ByteWriter offset;
    offset.number(static_cast<std::uint8_t>(group.op)).number(summary_start + summary.size());
    offsets.record(McapOp::summary_offset, offset.number(std::uint64_t{group.records.size()}));
    summary.raw(group.records.bytes());
  }
  const std::uint64_t offsets_start = summary_start + summary.size();
  summary.raw(offsets.bytes());
  summary.number(static_cast<std::uint8_t>(McapOp::footer)).number(std::uint64_t{kMcapFooterBytes});
  summary.number(summary_start).number(offsets_start);
  summary.number(crc32_of(summary.bytes())).raw(std::as_bytes(std::span(kMcapMagic)));
  put(summary.bytes());
}

void McapWriter::finish() {
  flush();
  ByteWriter data_end, record;
  data_end.number(state_->data_crc);
  state_->put(record.record(McapOp::data_end, data_end).bytes());
  state_->put_summary();
  flush();
}

}  // namespace opal::recording
