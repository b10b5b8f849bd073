#include <opal/recording/chunked_recording.hpp>

#include <algorithm>
#include <deque>

namespace opal::recording {
namespace {

std::string at_byte(std::uint64_t offset) { return " at byte " + std::to_string(offset); }

/// Unpacks chunks as they are asked for. Chunks overlap in time, so the last few are kept.
class ChunkCache {
 public:
  explicit ChunkCache(const ChunkedRecording& recording) : recording_(recording) {}

  const Unpacked& whole(std::uint32_t chunk) {
    for (const Kept& kept : kept_)
      if (kept.chunk == chunk) return kept.unpacked;
    while (kept_.size() > 1 && (kept_.size() >= kMostChunks || bytes_ > kMostBytes)) {
      bytes_ -= kept_.front().unpacked.bytes.size();
      kept_.pop_front();
    }
    kept_.push_back({chunk, recording_.unpacked(recording_.chunks()[chunk])});
    bytes_ += kept_.back().unpacked.bytes.size();
    return kept_.back().unpacked;
  }

 private:
  struct Kept {
    std::uint32_t chunk;
    Unpacked unpacked;
  };
  static constexpr std::size_t kMostChunks = 64;
  static constexpr std::size_t kMostBytes = std::size_t{1} << 27;

  const ChunkedRecording& recording_;
  std::deque<Kept> kept_;
  std::size_t bytes_ = 0;
};

struct Wanted {
  MessagePlace place;
  std::size_t topic;
};

class ChunkWalk final : public MessageWalk {
 public:
  ChunkWalk(const ChunkedRecording& recording, std::vector<Wanted> wanted)
      : recording_(recording), wanted_(std::move(wanted)), cache_(recording) {}

  std::optional<Message> next() override {
    while (next_ < wanted_.size()) {
      const Wanted& wanted = wanted_[next_++];
      if (const std::optional<Bytes> data = data_of(wanted.place))
        return Message{wanted.topic, wanted.place.recorded_ns, *data};
    }
    return std::nullopt;
  }
  const Defects& defects() const override { return defects_; }

 private:
  std::optional<Bytes> data_of(const MessagePlace& place) {
    const Chunk& chunk = recording_.chunks()[place.chunk];
    const Unpacked& unpacked = cache_.whole(place.chunk);
    try {
      // What stands before the end of the file is all that there is of a chunk that was cut.
      if (!unpacked.damage.empty() && !chunk.is_cut) throw Damage(unpacked.damage);
      return recording_.message_at(place, unpacked.bytes);
    } catch (const Damage& damage) {
      ++defects_["message in a damaged chunk" + at_byte(chunk.offset) + ": " + damage.what()];
      return std::nullopt;
    }
  }

  const ChunkedRecording& recording_;
  std::vector<Wanted> wanted_;
  ChunkCache cache_;
  std::size_t next_ = 0;
  Defects defects_;
};

}  // namespace

ChunkedRecording::~ChunkedRecording() = default;

void ChunkedRecording::add_channel(std::uint32_t channel, const Topic& topic) {
  if (knows(channel)) return;
  const auto same = std::find_if(topics_.begin(), topics_.end(), [&](const Topic& known) {
    return known.name == topic.name && known.type == topic.type && known.wire == topic.wire;
  });
  topic_by_channel_[channel] = static_cast<std::size_t>(same - topics_.begin());
  if (same == topics_.end()) topics_.push_back(topic);
}

std::uint32_t ChunkedRecording::add_chunk(Chunk chunk) {
  chunks_.push_back(std::move(chunk));
  return static_cast<std::uint32_t>(chunks_.size() - 1);
}

void ChunkedRecording::forget_index(std::uint32_t chunk) {
  chunks_[chunk].is_indexed = false;
  std::erase_if(places_, [chunk](const MessagePlace& place) { return place.chunk == chunk; });
}

Unpacked ChunkedRecording::unpacked(const Chunk& chunk) const {
  try {
    if (chunk.stored_bytes > kMostChunkBytes)
      throw Damage("a chunk of " + std::to_string(chunk.stored_bytes) + " bytes, expected at most " +
                   std::to_string(kMostChunkBytes));
    Unpacked unpacked = unpack(chunk, file_.read(chunk.offset, chunk.stored_bytes));
    const std::uint32_t crc = chunk.crc == 0 || !unpacked.damage.empty() ? chunk.crc : crc32_of(unpacked.bytes);
    if (crc != chunk.crc)
      unpacked.damage = "its CRC is " + std::to_string(crc) + ", expected " + std::to_string(chunk.crc);
    return unpacked;
  } catch (const Damage& damage) {
    return {{}, damage.what()};
  }
}

std::set<std::uint32_t> ChunkedRecording::chunks_to_read() const {
  std::set<std::uint32_t> chunks;
  for (std::uint32_t chunk = 0; chunk < chunks_.size(); ++chunk)
    if (!chunks_[chunk].is_indexed) chunks.insert(chunk);
  for (const MessagePlace& place : places_)
    if (!knows(place.channel)) chunks.insert(place.chunk);
  return chunks;
}

void ChunkedRecording::complete() {
  for (const std::uint32_t chunk : chunks_to_read()) {
    const Unpacked unpacked = this->unpacked(chunks_[chunk]);
    const bool is_usable = unpacked.damage.empty() || chunks_[chunk].is_cut;
    // Which messages a damaged chunk holds is not known, unless the index says so.
    if (!is_usable && !chunks_[chunk].is_indexed)
      count("damaged chunk without an index" + at_byte(chunks_[chunk].offset) + ": " + unpacked.damage);
    if (!is_usable) continue;
    const std::string damage = read_content(chunk, unpacked.bytes);
    if (!damage.empty() && !chunks_[chunk].is_cut) count(damage + " in the chunk" + at_byte(chunks_[chunk].offset));
  }
  const auto unknown = std::erase_if(places_, [this](const MessagePlace& place) { return !knows(place.channel); });
  if (unknown > 0) count("message of a topic that the file does not describe", static_cast<int>(unknown));
  std::stable_sort(places_.begin(), places_.end(), [](const MessagePlace& a, const MessagePlace& b) {
    return std::tie(a.recorded_ns, a.chunk, a.offset) < std::tie(b.recorded_ns, b.chunk, b.offset);
  });
}

std::pair<std::int64_t, std::int64_t> ChunkedRecording::span_ns() const {
  if (places_.empty()) return {0, 0};
  return {places_.front().recorded_ns, places_.back().recorded_ns};
}

std::vector<RecordedStamp> ChunkedRecording::stamps() const {
  std::vector<RecordedStamp> stamps;
  stamps.reserve(places_.size());
  for (const MessagePlace& place : places_) stamps.push_back({topic_by_channel_.at(place.channel), place.recorded_ns});
  return stamps;
}

std::unique_ptr<MessageWalk> ChunkedRecording::walk(const std::vector<std::size_t>& topics) const {
  std::vector<Wanted> wanted;
  for (const MessagePlace& place : places_) {
    const std::size_t topic = topic_by_channel_.at(place.channel);
    if (std::find(topics.begin(), topics.end(), topic) != topics.end()) wanted.push_back({place, topic});
  }
  return std::make_unique<ChunkWalk>(*this, std::move(wanted));
}

}  // namespace opal::recording
