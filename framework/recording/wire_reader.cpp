#include "recording/wire_reader.hpp"

#include <algorithm>

namespace opal::recording {
namespace {

constexpr std::size_t kHeaderBytes = 4;

}  // namespace

WireReader::WireReader(Bytes message, Wire wire) : wire_(wire) {
  if (wire == Wire::ros1) {
    body_ = message;
    swap_ = std::endian::native == std::endian::big;
    ok_ = true;
  }
  if (wire != Wire::cdr) return;
  if (message.size() < kHeaderBytes || message[0] != std::byte{0}) return;
  const bool big_endian = message[1] == std::byte{0};
  if (!big_endian && message[1] != std::byte{1}) return;
  swap_ = big_endian != (std::endian::native == std::endian::big);
  body_ = message.subspan(kHeaderBytes);
  ok_ = true;
}

void WireReader::align(std::size_t bytes) {
  if (wire_ == Wire::cdr) position_ = (position_ + bytes - 1) / bytes * bytes;
}

void WireReader::take(std::byte* to, std::size_t bytes) {
  if (!ok_ || position_ > body_.size() || bytes > body_.size() - position_) {
    ok_ = false;
    return;
  }
  std::copy_n(body_.data() + position_, bytes, to);
  position_ += bytes;
}

void WireReader::reverse(std::byte* bytes, std::size_t count) { std::reverse(bytes, bytes + count); }

std::size_t WireReader::length(std::size_t element_bytes) {
  const auto count = number<std::uint32_t>();
  if (!ok_ || count > (body_.size() - position_) / element_bytes) ok_ = false;
  return ok_ ? count : 0;
}

std::string WireReader::text() {
  const std::size_t bytes = length(1);  // in CDR its closing NUL included
  std::string text(bytes, '\0');
  take(reinterpret_cast<std::byte*>(text.data()), bytes);
  if (!ok_) return {};
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

Bytes WireReader::bytes() {
  const std::size_t count = length(1);
  if (!ok_) return {};
  const Bytes taken = body_.subspan(position_, count);
  position_ += count;
  return taken;
}

void WireReader::skip_numbers(std::size_t count, std::size_t bytes_each) {
  if (count == 0) return;
  align(bytes_each);
  if (!ok_ || position_ > body_.size() || count > (body_.size() - position_) / bytes_each)
    ok_ = false;
  else
    position_ += count * bytes_each;
}

std::optional<double> read_stamp(WireReader& wire) {
  const auto seconds = wire.number<std::int32_t>();
  const auto nanoseconds = wire.number<std::uint32_t>();
  if (!wire.ok() || nanoseconds >= 1'000'000'000u) return std::nullopt;
  return seconds + 1e-9 * nanoseconds;
}

std::optional<MessageHeader> read_header(WireReader& wire) {
  if (wire.wire() == Wire::ros1) wire.skip_numbers(1, sizeof(std::uint32_t));  // a running number
  const std::optional<double> stamp_s = read_stamp(wire);
  if (!stamp_s) return std::nullopt;
  MessageHeader header{*stamp_s, wire.text()};
  if (!wire.ok()) return std::nullopt;
  return header;
}

}  // namespace opal::recording
