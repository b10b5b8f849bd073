#pragma once

#include <opal/recording/recording.hpp>

#include <algorithm>
#include <type_traits>

namespace opal::recording {

/// Reads little-endian numbers and texts one after the other. Reading past the end gives zeros and makes `ok` false for
/// good.
class ByteReader {
 public:
  /// Reads from the start of `bytes`, which must outlive the reader.
  explicit ByteReader(Bytes bytes) : rest_(bytes) {}

  /// An integer of as many bytes as its type has.
  template <class Integer>
  Integer number() {
    static_assert(std::is_unsigned_v<Integer>);
    Integer value = 0;
    const Bytes taken = bytes(sizeof(Integer));
    for (std::size_t i = 0; i < taken.size(); ++i)
      value = static_cast<Integer>(value | static_cast<Integer>(static_cast<Integer>(taken[i]) << (8 * i)));
    return value;
  }
  /// So many bytes as they are; none if there are fewer.
  Bytes bytes(std::uint64_t count) {
    ok_ = ok_ && count <= rest_.size();
    if (!ok_) return {};
    const Bytes taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }
  /// A text after its length of four bytes.
  std::string text() {
    const Bytes taken = bytes(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(taken.data()), taken.size()};
  }
  /// What was not read yet.
  Bytes rest() const { return rest_; }
  /// Whether all that was asked for was there.
  bool ok() const { return ok_; }

 private:
  Bytes rest_;
  bool ok_ = true;
};

}  // namespace opal::recording
