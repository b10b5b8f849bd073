#include "viewer/encoding/record_packer.hpp"

#include <opal/common/error.hpp>

#include <zlib.h>

#include <array>

namespace opal {
namespace {

constexpr int kGzipWindow = 15 + 16;  // zlib: 16 more asks for a gzip header
constexpr int kLevel = 6, kMemory = 9;

}  // namespace

RecordPacker::RecordPacker() : stream_(std::make_unique<z_stream>()) {
  if (deflateInit2(stream_.get(), kLevel, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw Error("zlib: no memory to compress with");
}

RecordPacker::RecordPacker(RecordPacker&&) noexcept = default;

RecordPacker::~RecordPacker() {
  if (stream_) deflateEnd(stream_.get());
}

void RecordPacker::add(std::string_view record) {
  deflate_all(record, Z_NO_FLUSH);
  deflate_all("\n", Z_NO_FLUSH);
}

std::size_t RecordPacker::size() const { return (compressed_.size() + 2) / 3 * 4; }

std::string RecordPacker::finish() {
  deflate_all({}, Z_FINISH);
  return base64(compressed_);
}

void RecordPacker::deflate_all(std::string_view input, int flush) {
  std::array<unsigned char, 1 << 15> block;
  stream_->next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(input.data()));
  stream_->avail_in = static_cast<unsigned>(input.size());
  do {
    stream_->next_out = block.data();
    stream_->avail_out = static_cast<unsigned>(block.size());
    deflate(stream_.get(), flush);
    compressed_.append(reinterpret_cast<const char*>(block.data()), block.size() - stream_->avail_out);
  } while (stream_->avail_out == 0);
}

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const auto byte = [&](std::size_t i) {
      return k + i < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[k + i])) : 0u;
    };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += kDigits[group >> 18 & 63];
    text += kDigits[group >> 12 & 63];
    text += k + 1 < bytes.size() ? kDigits[group >> 6 & 63] : '=';
    text += k + 2 < bytes.size() ? kDigits[group & 63] : '=';
  }
  return text;
}

}  // namespace opal
