#pragma once

#include <opal/recording/chunk_codec.hpp>

#include <iosfwd>
#include <set>

namespace opal::recording {

/// A file of which any part can be read.
class RecordFile {
 public:
  /// Takes over a stream that can be positioned.
  explicit RecordFile(std::unique_ptr<std::istream> stream);
  ~RecordFile();
  /// Takes over another file, which must not be used any more.
  RecordFile(RecordFile&&) noexcept;
  /// Takes over another file, which must not be used any more.
  RecordFile& operator=(RecordFile&&) noexcept;

  /// The number of bytes when it was opened.
  std::uint64_t size() const { return size_; }
  /// Up to so many bytes from there on: fewer where the file ends.
  std::vector<std::byte> read(std::uint64_t offset, std::uint64_t count) const;

 private:
  std::unique_ptr<std::istream> stream_;
  std::uint64_t size_ = 0;
};

/// Opens a file to read it. @throws LogError naming it, if it is missing or no regular file.
/// @param expected  what it should be: "an MCAP recording".
RecordFile open_record_file(const std::string& path, const std::string& expected);

/// A part of the file that holds messages, packed or not.
struct Chunk {
  std::uint64_t offset = 0;        ///< where its packed bytes start in the file
  std::uint64_t stored_bytes = 0;  ///< how many those are
  std::uint64_t whole_bytes = 0;   ///< how many come out
  std::string compression;         ///< as the container names it
  std::uint32_t crc = 0;           ///< of what comes out; 0: not stated
  bool is_indexed = false;         ///< its messages stand in the file's index
  bool is_cut = false;             ///< the file ends in it: what comes out is its beginning
};

/// Where a message stands.
struct MessagePlace {
  std::int64_t recorded_ns = 0;  ///< since 1970
  std::uint32_t channel = 0;     ///< the container's number for who sent it
  std::uint32_t chunk = 0;       ///< index of the chunk
  std::uint64_t offset = 0;      ///< of its record in what comes out of the chunk
};

/// A recording in chunks of messages with an index behind each: MCAP, and the bags of ROS 1. A container's reader walks
/// the records of the file (`add_*`), then calls `complete`.
class ChunkedRecording : public Recording {
 public:
  ~ChunkedRecording() override;
  const std::vector<Topic>& topics() const override { return topics_; }
  std::pair<std::int64_t, std::int64_t> span_ns() const override;
  std::vector<RecordedStamp> stamps() const override;
  std::unique_ptr<MessageWalk> walk(const std::vector<std::size_t>& topics) const override;
  const Defects& defects() const override { return defects_; }

  /// What comes out of a chunk, and whether all of it is as the file states.
  Unpacked unpacked(const Chunk& chunk) const;
  /// A message's bytes in what comes out of its chunk. @throws Damage if there is none at this place.
  virtual Bytes message_at(const MessagePlace& place, Bytes whole) const = 0;
  /// The chunks by their places in the file.
  const std::vector<Chunk>& chunks() const { return chunks_; }

 protected:
  /// Takes over the file. It reads nothing yet.
  explicit ChunkedRecording(RecordFile file) : file_(std::move(file)) {}

  /// The file that is read.
  const RecordFile& file() const { return file_; }
  /// Several channels may be one topic.
  void add_channel(std::uint32_t channel, const Topic& topic);
  /// Whether the topic of a channel was added.
  bool knows(std::uint32_t channel) const { return topic_by_channel_.contains(channel); }
  /// @return its index
  std::uint32_t add_chunk(Chunk chunk);
  /// An unpacked chunk that grows while its records are found.
  void extend_last_chunk(std::uint64_t end) {
    chunks_.back().stored_bytes = chunks_.back().whole_bytes = end - chunks_.back().offset;
  }
  /// Adds a message. Its channel may become known later, before `complete` ends.
  void add_place(const MessagePlace& place) { places_.push_back(place); }
  /// Takes back what an index says of a chunk: its messages are to be found by reading it.
  void forget_index(std::uint32_t chunk);
  /// The index has named all messages of the chunk.
  void mark_indexed(std::uint32_t chunk) { chunks_[chunk].is_indexed = true; }
  /// How many messages were added.
  std::size_t message_count() const { return places_.size(); }
  /// Counts something that is not whole: its place, what was found and what was expected.
  void count(const std::string& defect, int times = 1) { defects_[defect] += times; }

  /// Reads the chunks that no index describes and those with unknown channels, and sorts the messages by time.
  void complete();

  /// What comes out of the packed bytes of a chunk. @throws Damage if it cannot be unpacked at all.
  virtual Unpacked unpack(const Chunk& chunk, Bytes packed) const = 0;
  /// Finds channels in what comes out of a chunk, and messages (`add_place`) if it is not indexed.
  /// @return what is damaged; empty: nothing.
  virtual std::string read_content(std::uint32_t chunk, Bytes whole) = 0;

 private:
  std::set<std::uint32_t> chunks_to_read() const;

  RecordFile file_;
  std::vector<Topic> topics_;
  std::map<std::uint32_t, std::size_t> topic_by_channel_;
  std::vector<Chunk> chunks_;
  std::vector<MessagePlace> places_;
  Defects defects_;
};

}  // namespace opal::recording
