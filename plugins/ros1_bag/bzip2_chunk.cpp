#include "bzip2_chunk.hpp"

#include <bzlib.h>

namespace opal::ros1_bag {
namespace {

class Bzip2 {
 public:
  explicit Bzip2(recording::Bytes packed) {
    BZ2_bzDecompressInit(&stream_, 0, 0);
    stream_.next_in = const_cast<char*>(reinterpret_cast<const char*>(packed.data()));
    stream_.avail_in = static_cast<unsigned>(packed.size());
  }
  ~Bzip2() { BZ2_bzDecompressEnd(&stream_); }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;

  /// @return as BZ2_bzDecompress; `made` is how many bytes came out.
  int step(std::span<std::byte> room, std::size_t& made) {
    stream_.next_out = reinterpret_cast<char*>(room.data());
    stream_.avail_out = static_cast<unsigned>(room.size());
    const int result = BZ2_bzDecompress(&stream_);
    made = room.size() - stream_.avail_out;
    return result;
  }

 private:
  bz_stream stream_{};
};

}  // namespace

recording::Unpacked unpack_bzip2(recording::Bytes packed, std::uint64_t whole_bytes) {
  recording::expect_chunk_size(whole_bytes);
  constexpr std::size_t kRoomBytes = 1 << 18;
  Bzip2 bzip2(packed);
  recording::Unpacked unpacked;
  std::vector<std::byte> room(kRoomBytes);
  int result = BZ_OK;
  while (result == BZ_OK && unpacked.bytes.size() <= whole_bytes) {
    std::size_t made = 0;
    result = bzip2.step(room, made);
    unpacked.bytes.insert(unpacked.bytes.end(), room.begin(), room.begin() + static_cast<std::ptrdiff_t>(made));
    if (result == BZ_OK && made == 0) break;  // it ends too early
  }
  if (result != BZ_STREAM_END && result != BZ_OK) unpacked.damage = "bz2: error " + std::to_string(result);
  if (unpacked.damage.empty() && unpacked.bytes.size() != whole_bytes)
    unpacked.damage =
        std::to_string(unpacked.bytes.size()) + " bytes come out of it, expected " + std::to_string(whole_bytes);
  return unpacked;
}

}  // namespace opal::ros1_bag
