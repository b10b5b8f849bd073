#pragma once

#include <opal/common/export.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace opal {

/// SHA-256 (FIPS 180-4) of what is added, as 64 hexadecimal digits; by OpenSSL.
class OPAL_EXPORT Sha256 {
 public:
  /// @throws Error if this machine's OpenSSL does not offer it.
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view bytes);
  /// Of everything so far; nothing may be added afterwards.
  std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

OPAL_EXPORT std::string sha256_of(std::string_view bytes);
/// @throws Error naming the file if it cannot be read.
OPAL_EXPORT std::string sha256_of_file(const std::string& path);

}  // namespace opal
