#include "bag_recording.hpp"

#include "bzip2_chunk.hpp"

#include <opal/common/error.hpp>
#include <opal/common/file_start.hpp>
#include <opal/recording/byte_reader.hpp>

#include <algorithm>
#include <cstring>

namespace opal::ros1_bag {
namespace {

using recording::ByteReader;
using recording::Bytes;
using recording::Chunk;
using recording::MessagePlace;

constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";
constexpr std::uint32_t kMostHeaderBytes = 1 << 16;  // a header has a few short fields
constexpr std::uint64_t kWindowBytes = 1 << 16;      // the search for the next record reads so many at a time

/// The first byte of the field "op".
enum class Op : std::uint8_t { none = 0, message = 2, bag = 3, index = 4, chunk = 5, chunk_info = 6, connection = 7 };

/// The fields of a record's header, as views of its bytes.
class Fields {
 public:
  explicit Fields(Bytes header) {
    ByteReader reader(header);
    while (reader.ok() && !reader.rest().empty()) {
      const Bytes field = reader.bytes(reader.number<std::uint32_t>());
      const std::string_view text(reinterpret_cast<const char*>(field.data()), field.size());
      const std::size_t equals = text.find('=');
      if (!reader.ok() || equals == std::string_view::npos) return;
      fields_.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    is_whole_ = reader.ok();
  }
  bool is_whole() const { return is_whole_; }
  std::string_view text(std::string_view name) const {
    for (const auto& [known, value] : fields_)
      if (known == name) return value;
    return {};
  }
  template <class Integer>
  Integer number(std::string_view name) const {
    return ByteReader(std::as_bytes(std::span(text(name)))).number<Integer>();
  }
  Op op() const {
    const auto op = number<std::uint8_t>("op");
    return is_whole_ && op >= 2 && op <= 7 ? static_cast<Op>(op) : Op::none;
  }

 private:
  std::vector<std::pair<std::string_view, std::string_view>> fields_;
  bool is_whole_ = false;
};

std::int64_t nanoseconds(std::uint64_t stamp) {
  constexpr std::int64_t kPerSecond = 1'000'000'000;
  return static_cast<std::int64_t>(stamp & 0xffffffffu) * kPerSecond + static_cast<std::int64_t>(stamp >> 32);
}

/// A record in memory.
struct BagRecord {
  Bytes header;
  Bytes data;
};

/// @return nullopt if there is no whole record.
std::optional<BagRecord> take_record(ByteReader& reader) {
  BagRecord record;
  record.header = reader.bytes(reader.number<std::uint32_t>());
  record.data = reader.bytes(reader.number<std::uint32_t>());
  return reader.ok() ? std::optional(record) : std::nullopt;
}

class BagRecording final : public recording::ChunkedRecording {
 public:
  BagRecording(recording::RecordFile file, std::string name)
      : ChunkedRecording(std::move(file)), name_(std::move(name)) {}

  void read();
  Bytes message_at(const MessagePlace& place, Bytes whole) const override;

 protected:
  recording::Unpacked unpack(const Chunk& chunk, Bytes packed) const override;
  std::string read_content(std::uint32_t chunk, Bytes whole) override;

 private:
  /// A record of the file: its header, and where its data are.
  struct Place {
    std::vector<std::byte> header;
    std::uint64_t data = 0;
    std::uint64_t end = 0;  // may lie behind the end of the file
  };
  std::optional<Place> record_at(std::uint64_t position) const;
  std::uint64_t next_record(std::uint64_t position) const;
  void walk_records();
  void walk_record(const Place& record, const Fields& fields);
  void read_bag_header(const Fields& fields);
  void begin_chunk(const Place& record, const Fields& fields);
  void read_index(const Place& record, const Fields& fields);
  void read_connection(const Fields& fields, Bytes data);

  std::string name_;
  std::optional<std::uint32_t> indexed_chunk_;  // whose index is being read
  bool has_header_ = false;
};

void BagRecording::read() {
  const std::vector<std::byte> start = file().read(0, kFirstLine.size());
  const std::string_view found(reinterpret_cast<const char*>(start.data()), start.size());
  if (found != kFirstLine)
    throw LogError(name_ + ": byte 0: does not begin with '#ROSBAG V2.0', expected a bag of ROS 1, version 2.0");
  walk_records();
  complete();
}

std::optional<BagRecording::Place> BagRecording::record_at(std::uint64_t position) const {
  constexpr std::uint64_t kLength = sizeof(std::uint32_t);
  const std::vector<std::byte> length = file().read(position, kLength);
  const auto header_bytes = ByteReader(length).number<std::uint32_t>();
  if (length.size() < kLength || header_bytes == 0 || header_bytes > kMostHeaderBytes) return std::nullopt;
  Place place;
  place.header = file().read(position + kLength, header_bytes + kLength);
  if (place.header.size() < header_bytes + kLength) return std::nullopt;
  const auto data_bytes = ByteReader(Bytes(place.header).last(kLength)).number<std::uint32_t>();
  place.header.resize(header_bytes);
  const Op op = Fields(place.header).op();
  place.data = position + 2 * kLength + header_bytes;
  place.end = place.data + data_bytes;
  // Only of a chunk the part before the end of the file is of use.
  if (op == Op::none || (place.end > file().size() && op != Op::chunk)) return std::nullopt;
  return place;
}

/// Where the next record starts: every one has a field "op=" in its header.
std::uint64_t BagRecording::next_record(std::uint64_t position) const {
  constexpr std::string_view kField("\x04\0\0\0op=", 7);
  constexpr std::uint64_t kLongestBefore = 512;  // other fields of a header
  for (std::uint64_t window = position; window < file().size(); window += kWindowBytes) {
    const std::uint64_t begin = std::max(position, window - std::min(window, kLongestBefore));
    const std::vector<std::byte> bytes = file().read(begin, window + kWindowBytes + kField.size() - begin);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    for (std::size_t at = text.find(kField, window - begin); at != text.npos; at = text.find(kField, at + 1))
      for (std::size_t start = at - std::min<std::size_t>(at, kLongestBefore); start + 4 <= at; ++start) {
        // The header must reach as far as this field.
        const auto length = ByteReader(Bytes(bytes).subspan(start)).number<std::uint32_t>();
        const bool holds_field = start + length >= at && length < kMostHeaderBytes;
        if (holds_field && record_at(begin + start)) return begin + start;
      }
  }
  return file().size();
}

void BagRecording::walk_records() {
  std::uint64_t position = kFirstLine.size();
  while (position < file().size()) {
    if (const std::optional<Place> record = record_at(position)) {
      walk_record(*record, Fields(record->header));
      position = record->end;
      continue;
    }
    if (indexed_chunk_) forget_index(*indexed_chunk_);  // the rest of it is damaged or cut
    indexed_chunk_.reset();
    const std::uint64_t next = next_record(position);
    count("no whole record at byte " + std::to_string(position) + ": " + std::to_string(next - position) +
          " bytes are left out, expected a record of a bag");
    position = next;
  }
  if (indexed_chunk_) forget_index(*indexed_chunk_);  // more of it may have followed
  if (!has_header_) count("no header of a bag, expected one at byte " + std::to_string(kFirstLine.size()));
}

void BagRecording::read_bag_header(const Fields& fields) {
  has_header_ = true;
  const auto index_at = fields.number<std::uint64_t>("index_pos");
  if (index_at == 0) count("the bag was never closed: it is read without its index");
  if (index_at > file().size())
    count("the file ends at byte " + std::to_string(file().size()) + ", expected its index at byte " +
          std::to_string(index_at) + ": it was cut");
}

void BagRecording::walk_record(const Place& record, const Fields& fields) {
  const Op op = fields.op();
  if (op != Op::index) indexed_chunk_.reset();
  if (op == Op::chunk) begin_chunk(record, fields);
  if (op == Op::index) read_index(record, fields);
  if (op == Op::connection) read_connection(fields, file().read(record.data, record.end - record.data));
  if (op == Op::bag) read_bag_header(fields);
}

void BagRecording::begin_chunk(const Place& record, const Fields& fields) {
  Chunk chunk;
  chunk.offset = record.data;
  chunk.stored_bytes = record.end - record.data;
  chunk.whole_bytes = fields.number<std::uint32_t>("size");
  chunk.compression = fields.text("compression");
  chunk.is_cut = record.end > file().size();
  if (chunk.is_cut) {
    chunk.stored_bytes = file().size() - std::min(record.data, file().size());
    count("the file ends at byte " + std::to_string(file().size()) + " in the chunk at byte " +
          std::to_string(record.data) + ", expected " + std::to_string(record.end) +
          " bytes; its whole messages are read");
  }
  indexed_chunk_ = add_chunk(chunk);
}

/// The indices of a chunk's connections stand behind it: time and place of each message.
void BagRecording::read_index(const Place& record, const Fields& fields) {
  if (!indexed_chunk_ || fields.number<std::uint32_t>("ver") != 1) return;
  const std::vector<std::byte> data = file().read(record.data, record.end - record.data);
  ByteReader entries(data);
  MessagePlace place;
  place.chunk = *indexed_chunk_;
  place.channel = fields.number<std::uint32_t>("conn");
  while (entries.ok() && !entries.rest().empty()) {
    place.recorded_ns = nanoseconds(entries.number<std::uint64_t>());
    place.offset = entries.number<std::uint32_t>();
    if (entries.ok()) add_place(place);
  }
  mark_indexed(*indexed_chunk_);
}

void BagRecording::read_connection(const Fields& fields, Bytes data) {
  const std::string_view type = Fields(data).text("type");
  if (fields.text("conn").size() != sizeof(std::uint32_t) || type.empty()) return;
  add_channel(fields.number<std::uint32_t>("conn"),
              {std::string(fields.text("topic")), std::string(type), recording::Wire::ros1});
}

recording::Unpacked BagRecording::unpack(const Chunk& chunk, Bytes packed) const {
  if (chunk.compression == "bz2") return unpack_bzip2(packed, chunk.whole_bytes);
  return recording::unpack_chunk(chunk.compression == "none" ? "" : chunk.compression, packed, chunk.whole_bytes);
}

/// @return what is damaged
std::string BagRecording::read_content(std::uint32_t chunk, Bytes whole) {
  const bool is_indexed = chunks()[chunk].is_indexed;
  ByteReader records(whole);
  while (!records.rest().empty()) {
    MessagePlace place;
    place.chunk = chunk;
    place.offset = whole.size() - records.rest().size();
    const std::optional<BagRecord> record = take_record(records);
    const Fields fields(record ? record->header : Bytes());
    if (!record || fields.op() == Op::none) return "no whole record " + std::to_string(place.offset) + " bytes";
    if (fields.op() == Op::connection) read_connection(fields, record->data);
    if (fields.op() != Op::message || is_indexed) continue;
    place.channel = fields.number<std::uint32_t>("conn");
    place.recorded_ns = nanoseconds(fields.number<std::uint64_t>("time"));
    add_place(place);
  }
  return "";
}

Bytes BagRecording::message_at(const MessagePlace& place, Bytes whole) const {
  ByteReader reader(whole);
  reader.bytes(place.offset);
  const std::optional<BagRecord> record = take_record(reader);
  const Fields fields(record ? record->header : Bytes());
  if (!record || fields.op() != Op::message || fields.number<std::uint32_t>("conn") != place.channel)
    throw recording::Damage("no message of this topic where its index leads, expected one");
  return record->data;
}

std::unique_ptr<recording::Recording> read_whole(recording::RecordFile file, const std::string& name) {
  auto bag = std::make_unique<BagRecording>(std::move(file), name);
  bag->read();
  return bag;
}

}  // namespace

bool is_bag(const std::string& path) { return first_bytes(path, kFirstLine.size()) == kFirstLine; }

std::unique_ptr<recording::Recording> read_bag(const std::string& path) {
  return read_whole(recording::open_record_file(path, "a bag of ROS 1"), path);
}

std::unique_ptr<recording::Recording> read_bag(std::unique_ptr<std::istream> stream, const std::string& name) {
  return read_whole(recording::RecordFile(std::move(stream)), name);
}

}  // namespace opal::ros1_bag
