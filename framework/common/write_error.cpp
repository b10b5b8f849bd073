#include "common/write_error.hpp"

#include <cerrno>
#include <system_error>

namespace opal {

WriteError::WriteError(const std::string& path, int cause)
    : Error(path + ": cannot be written: " + cause_text(cause)) {}
WriteError::~WriteError() = default;

std::string cause_text(int cause) {
  if (cause == 0) return "unknown cause";
  if (cause == EFBIG) return "File too large: a limit of the file system, or 'ulimit -f'";
  return std::generic_category().message(cause);
}

}  // namespace opal
