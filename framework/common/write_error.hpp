#pragma once

#include <opal/common/error.hpp>

namespace opal {

/// A file or folder cannot be written: the disk is full, the file system is read-only, there is no permission. The
/// message names the file and the cause.
class OPAL_EXPORT WriteError : public Error {
 public:
  using Error::Error;
  /// @param cause  an errno
  WriteError(const std::string& path, int cause);
  ~WriteError() override;
};

/// What an errno means, and what a person can do about it where that is not said: "No space left on device".
OPAL_EXPORT std::string cause_text(int cause);

}  // namespace opal
