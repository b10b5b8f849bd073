#pragma once

#include <opal/recording/recording.hpp>

#include <cstring>
#include <optional>
#include <string>
#include <type_traits>

namespace opal::recording {

/// Reads a message: plain CDR (OMG DDS-XTypes 1.3, 7.4.1: XCDR version 1) with its encapsulation header in either byte
/// order, or the format of ROS 1. Reading past the end gives zeros and makes `ok` false for good.
class WireReader {
 public:
  WireReader(Bytes message, Wire wire);

  template <class Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number>);
    std::byte bytes[sizeof(Number)] = {};
    align(sizeof(Number));
    take(bytes, sizeof(Number));
    if (swap_) reverse(bytes, sizeof(Number));
    Number value;
    std::memcpy(&value, bytes, sizeof(Number));
    return value;
  }
  std::string text();
  /// The length of a sequence whose elements take at least `element_bytes` each; 0 if so many do not fit in.
  std::size_t length(std::size_t element_bytes);
  /// A sequence of bytes, where it lies in the message.
  Bytes bytes();
  void skip_numbers(std::size_t count, std::size_t bytes_each);

  Wire wire() const { return wire_; }
  bool ok() const { return ok_; }

 private:
  void align(std::size_t bytes);
  void take(std::byte* to, std::size_t bytes);
  static void reverse(std::byte* bytes, std::size_t count);

  Wire wire_;
  Bytes body_;  // alignment counts from its start
  std::size_t position_ = 0;
  bool swap_ = false;
  bool ok_ = false;
};

/// builtin_interfaces/Time [s]. @return nullopt for a damaged one.
std::optional<double> read_stamp(WireReader& wire);

/// std_msgs/Header.
struct MessageHeader {
  double stamp_s = 0;
  std::string frame;
};

/// @return nullopt for a damaged one.
std::optional<MessageHeader> read_header(WireReader& wire);

}  // namespace opal::recording
