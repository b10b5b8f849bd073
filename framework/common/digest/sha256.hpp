#pragma once

#include <opal/common/export.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace opal {

/// SHA-256 (FIPS 180-4, 6.2) of what is added, as 64 hexadecimal digits.
class OPAL_EXPORT Sha256 {
 public:
  void add(std::string_view bytes);
  /// Of everything so far; nothing may be added afterwards.
  std::string finish();

 private:
  static constexpr std::size_t kBlock = 64;  // bytes

  void take(const unsigned char* block);

  std::array<std::uint32_t, 8> hash_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                     0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};  // FIPS 180-4, 5.3.3
  std::array<unsigned char, kBlock> rest_{};                                           // that fills no block yet
  std::uint64_t bytes_ = 0;
};

OPAL_EXPORT std::string sha256_of(std::string_view bytes);
/// @throws Error naming the file if it cannot be read.
OPAL_EXPORT std::string sha256_of_file(const std::string& path);

}  // namespace opal
