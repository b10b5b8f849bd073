#pragma once

#include "common/prepared/prepared_folder.hpp"
#include "patterns/pattern_index.hpp"

#include <functional>

namespace opal {

/// Keeps the patterns of large maps in files, one for each map and template.
class OPAL_EXPORT PatternCache {
 public:
  /// The patterns of smaller maps are put into order sooner than a file is opened and checked.
  static constexpr std::size_t kLargeMap = 10000;

  using Visit = std::function<void(const PatternInstance&)>;
  /// Visits all patterns of a template, the same ones each time: once to know the file again, and once to make it.
  using EachPattern = std::function<void(const Visit&)>;

  /// @param folder  made when needed; empty: nothing is kept.
  /// @param from  so many members on, patterns are kept.
  explicit PatternCache(std::filesystem::path folder, std::size_t from = kLargeMap)
      : folder_(std::move(folder)), from_(from) {}

  /// Indexed, or as a file has them. What cannot be kept is indexed, and a warning says so.
  /// @param members  every number of a member is less.
  PatternIndex index_of(const EachPattern& each, std::size_t members) const;

 private:
  PreparedFolder folder_;
  std::size_t from_;
};

}  // namespace opal
