#pragma once

#include "common/digest/sha256.hpp"
#include "patterns/pattern_index.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace opal {

/// What an index depends on: the patterns as they are found, and how they are put into order. What a template makes of
/// a map depends on its code, which may be anybody's: so what it made is what counts.
class OPAL_EXPORT PatternDigest {
 public:
  PatternDigest();
  void add(const PatternInstance& pattern);
  /// As 64 hexadecimal digits; nothing may be added afterwards.
  std::string finish();

 private:
  void flush();

  Sha256 digest_;
  std::string bytes_;  ///< that are still to be added
};

/// A file that is mapped into memory where it is read. It is of this kind of machine.
/// @throws WriteError. The file is there when it is whole.
OPAL_EXPORT void write_patterns(const std::filesystem::path& file, const std::string& digest,
                                const PatternIndex& index);

/// @param digest   that the file must have.
/// @param members  every number of a member must be less.
/// @return nothing if there is no such file, or it is not whole, or of other patterns, program or kind of machine.
OPAL_EXPORT std::optional<PatternIndex> read_patterns(const std::filesystem::path& file, const std::string& digest,
                                                      int members);

}  // namespace opal
