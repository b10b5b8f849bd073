#pragma once

#include <opal/recording/chunk_codec.hpp>

namespace opal::ros1_bag {

/// Unpacks a chunk as recording::unpack_chunk does.
recording::Unpacked unpack_bzip2(recording::Bytes packed, std::uint64_t whole_bytes);

}  // namespace opal::ros1_bag
