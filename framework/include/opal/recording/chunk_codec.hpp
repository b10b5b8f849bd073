#pragma once

#include <opal/recording/recording.hpp>

#include <stdexcept>

namespace opal::recording {

/// A part of a file that is not what it has to be; the message says what was found and what was expected.
class Damage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes that came out of a chunk.
struct Unpacked {
  std::vector<std::byte> bytes;  ///< all of them, or what stands before the damage
  std::string damage;            ///< empty: the chunk is whole
};

/// No chunk is larger: what claims to be is damaged. Recorders write chunks of about a megabyte.
constexpr std::uint64_t kMostChunkBytes = std::uint64_t{1} << 28;
/// @throws Damage if it is larger.
void expect_chunk_size(std::uint64_t whole_bytes);

/// Unpacks a chunk.
/// @param compression  "" for none, "lz4" (frame format) or "zstd".
/// @param whole_bytes  the size that the file states of what comes out.
/// @throws Damage for another compression, and for a size above kMostChunkBytes.
Unpacked unpack_chunk(const std::string& compression, Bytes packed, std::uint64_t whole_bytes);
/// Packs a chunk; the same names of compressions.
std::vector<std::byte> pack_chunk(const std::string& compression, Bytes whole);
/// The CRC-32 of zlib (ISO 3309), going on from that of the bytes before.
std::uint32_t crc32_of(Bytes bytes, std::uint32_t before = 0);

}  // namespace opal::recording
