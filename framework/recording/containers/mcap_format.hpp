#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace opal::recording {

/// What an MCAP file begins and ends with (https://mcap.dev/spec).
constexpr std::array<unsigned char, 8> kMcapMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

/// The first byte of a record; its length of eight bytes follows.
enum class McapOp : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

constexpr std::size_t kMcapRecordStart = 9;    // op and length
constexpr std::size_t kMcapFooterBytes = 20;   // without op and length
constexpr std::size_t kMcapMessageStart = 22;  // of a message, before its data

}  // namespace opal::recording
