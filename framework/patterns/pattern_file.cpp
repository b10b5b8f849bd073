#include "patterns/pattern_file.hpp"

#include "common/prepared/section_file.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

// To be raised when the same patterns are put into another order: files of before then belong to no map.
constexpr int kOrderedAs = 1;

using Sizes = std::array<std::uint64_t, 2>;  ///< dimensions and slots

SectionKey key_of(const std::string& digest) { return {{'p', 'a', 't', 't', 'e', 'r', 'n', 's'}, digest}; }

/// A search sweeps along an extent, so it must have an end; a map reaches no farther.
bool is_place(double value) {
  constexpr double kFarthest = 1e8;
  return std::abs(value) <= kFarthest;  // and no NaN
}

/// Whoever follows a number in the table stays within the members.
bool are_sound(const PatternTable::Columns& columns, int members) {
  const auto all_places = [](const auto& column) {
    const auto values = column.values();
    return std::ranges::all_of(values, [](const auto& numbers) { return std::ranges::all_of(numbers, is_place); });
  };
  const std::size_t patterns = columns.frames.size(), extents = columns.extents_m.size();
  const auto numbers = columns.members.values();
  return numbers.size() == patterns * columns.slots && (extents == 0 || extents == patterns) &&
         all_places(columns.frames) && all_places(columns.extents_m) &&
         std::ranges::all_of(numbers, [members](int number) { return number >= 0 && number < members; });
}

}  // namespace

PatternDigest::PatternDigest() { digest_.add(std::to_string(kOrderedAs)); }

void PatternDigest::add(const PatternInstance& pattern) {
  const auto put = [this](const auto& value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(pattern.members.size());
  put(pattern.invariants.size());
  for (const int member : pattern.members) put(member);
  for (const Invariant& invariant : pattern.invariants) put(invariant.value);
  for (const double number :
       {pattern.frame.x(), pattern.frame.y(), pattern.frame.heading_rad(), pattern.extent_min_m, pattern.extent_max_m})
    put(number);
  constexpr std::size_t kEnough = 1 << 16;
  if (bytes_.size() >= kEnough) flush();
}

void PatternDigest::flush() {
  digest_.add(bytes_);
  bytes_.clear();
}

std::string PatternDigest::finish() {
  flush();
  return digest_.finish();
}

void write_patterns(const std::filesystem::path& file, const std::string& digest, const PatternIndex& index) {
  const PatternTable::Columns& table = index.patterns().columns();
  const InvariantTree::Arrays& tree = index.tree().arrays();
  const Sizes sizes{index.tree().dimensions(), table.slots};
  const std::array sections{Section(std::span<const Sizes>(&sizes, 1)),
                            Section(table.frames),
                            Section(table.members),
                            Section(table.extents_m),
                            Section(tree.order),
                            Section(tree.values),
                            Section(tree.boxes)};
  write_sections(file, key_of(digest), sections);
}

std::optional<PatternIndex> read_patterns(const std::filesystem::path& file, const std::string& digest, int members) {
  std::optional<Sections> sections = Sections::open(file, key_of(digest));
  if (!sections) return std::nullopt;
  const auto sizes = sections->next<Sizes>();
  if (sizes.size() != 1) return std::nullopt;
  const auto [dimensions, slots] = sizes[0];
  PatternTable::Columns table;
  table.slots = slots;
  table.frames = sections->next<std::array<double, 3>>();
  table.members = sections->next<int>();
  table.extents_m = sections->next<std::array<double, 2>>();
  InvariantTree::Arrays tree;
  tree.order = sections->next<int>();
  tree.values = sections->next<float>();
  tree.boxes = sections->next<InvariantTree::Interval>();
  if (!sections->are_whole() || !are_sound(table, members) ||
      !InvariantTree::are_sound(table.frames.size(), dimensions, tree))
    return std::nullopt;
  sections->let_go();
  return PatternIndex(PatternTable(std::move(table)), InvariantTree(dimensions, std::move(tree)));
}

}  // namespace opal
