#include "patterns/pattern_cache.hpp"

#include "patterns/pattern_file.hpp"

namespace opal {
namespace {

PatternIndex indexed(const PatternCache::EachPattern& each) {
  PatternList patterns;
  each([&](const PatternInstance& pattern) { patterns.add(pattern); });
  return PatternIndex(std::move(patterns));
}

std::string digest_of(const PatternCache::EachPattern& each) {
  PatternDigest digest;
  each([&](const PatternInstance& pattern) { digest.add(pattern); });
  return digest.finish();
}

}  // namespace

PatternIndex PatternCache::index_of(const EachPattern& each, std::size_t members) const {
  if (!folder_.keeps() || members < from_) return indexed(each);
  const std::string digest = digest_of(each);
  return folder_.kept<PatternIndex>(
      digest + ".patterns",
      [&](const std::filesystem::path& file) { return read_patterns(file, digest, static_cast<int>(members)); },
      [&] { return indexed(each); },
      [&](const std::filesystem::path& file, const PatternIndex& index) { write_patterns(file, digest, index); });
}

}  // namespace opal
