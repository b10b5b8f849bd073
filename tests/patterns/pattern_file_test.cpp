#include "patterns/pattern_file.hpp"
#include "columns.hpp"
#include "localization/search/candidate_generation.hpp"
#include "patterns/pattern_cache.hpp"

#include "tests/kit/damaged_bytes.hpp"
#include "tests/kit/file_content.hpp"
#include "tests/kit/same_bytes.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <random>

using namespace opal;
namespace fs = std::filesystem;

namespace {

constexpr int kMembers = 50;

/// Pairs of some members, of which some extend.
std::vector<PatternInstance> some_patterns(unsigned seed = 1, int count = 400) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-5, 5);
  std::vector<PatternInstance> patterns(static_cast<std::size_t>(count));
  for (PatternInstance& pattern : patterns) {
    pattern.members = {static_cast<int>(random() % kMembers), static_cast<int>(random() % kMembers)};
    pattern.invariants = {{value(random)}, {value(random)}, {value(random)}};
    pattern.frame = {value(random), value(random), 0.5 * value(random)};
    pattern.extent_max_m = random() % 2 == 0 ? 1 : 0;
  }
  return patterns;
}

std::string digest_of(const std::vector<PatternInstance>& patterns) {
  PatternDigest digest;
  for (const PatternInstance& pattern : patterns) digest.add(pattern);
  return digest.finish();
}

PatternCache::EachPattern each_of(const std::vector<PatternInstance>& patterns) {
  return [&patterns](const PatternCache::Visit& visit) {
    for (const PatternInstance& pattern : patterns) visit(pattern);
  };
}

bool same(const PatternIndex& a, const PatternIndex& b) {
  const auto &one = a.patterns().columns(), &other = b.patterns().columns();
  const auto &tree = a.tree().arrays(), &other_tree = b.tree().arrays();
  return one.slots == other.slots && a.tree().dimensions() == b.tree().dimensions() &&
         same_bytes(one.frames, other.frames) && same_bytes(one.members, other.members) &&
         same_bytes(one.extents_m, other.extents_m) && same_bytes(tree.order, other_tree.order) &&
         same_bytes(tree.values, other_tree.values) && same_bytes(tree.boxes, other_tree.boxes);
}

/// Asks for many patterns and all that is said of them, so that a number that leads outside is noticed.
void ask_everywhere(const PatternIndex& index) {
  PatternInstance all;
  for (std::size_t d = 0; d < index.tree().dimensions(); ++d) all.invariants.push_back({0, 3});
  for (const int number : index.find(all)) {
    CHECK(index.patterns().frame(number).position().allFinite());
    CHECK(std::abs(index.patterns().extent_m(number)[1]) < 1e9);
    for (const int member : index.patterns().members(number))
      if (member < 0 || member >= kMembers) FAIL("no such member: " << member);
  }
}

}  // namespace

TEST_CASE("patterns that were written are read as they were") {
  const TemporaryFolder folder;
  const auto patterns = some_patterns(GENERATE(1u, 2u), GENERATE(0, 1, 16, 17, 400));
  const std::string digest = digest_of(patterns);
  const fs::path file = folder.path_of("pairs.patterns");
  const PatternIndex index(patterns);
  write_patterns(file, digest, index);
  const auto read = read_patterns(file, digest, kMembers);
  REQUIRE(read);
  CHECK(same(*read, index));
  ask_everywhere(*read);
}

TEST_CASE("whatever changes the patterns changes their digest") {
  const auto patterns = some_patterns();
  std::array<std::vector<PatternInstance>, 6> others;
  others.fill(patterns);
  others[0].pop_back();
  others[1][7].members[1] += 1;
  others[2][7].invariants[2].value += 1e-9;
  others[3][7].frame = others[3][8].frame;
  others[4][7].extent_min_m -= 1e-9;
  std::swap(others[5][7], others[5][8]);
  for (const auto& other : others) CHECK(digest_of(other) != digest_of(patterns));
  CHECK(digest_of(patterns) == digest_of(some_patterns()));
}

TEST_CASE("a file of patterns that is of others, cut or grown gives nothing") {
  const TemporaryFolder folder;
  const auto patterns = some_patterns();
  const std::string digest = digest_of(patterns);
  const fs::path file = folder.path_of("pairs.patterns");
  CHECK_FALSE(read_patterns(file, digest, kMembers));
  write_patterns(file, digest, PatternIndex(patterns));
  CHECK_FALSE(read_patterns(file, digest_of(some_patterns(2)), kMembers));
  CHECK_FALSE(read_patterns(file, digest, kMembers - 10));  // it names members that the map does not have
  for (const std::string& other : cut_or_grown(content_of(file))) {
    CAPTURE(other.size());
    write_bytes(file, other);
    CHECK_FALSE(read_patterns(file, digest, kMembers));
  }
}

TEST_CASE("a file of patterns with wrong bytes gives nothing, or patterns that lead nowhere outside") {
  const TemporaryFolder folder;
  const auto patterns = some_patterns();
  const std::string digest = digest_of(patterns);
  const fs::path file = folder.path_of("pairs.patterns");
  write_patterns(file, digest, PatternIndex(patterns));
  int refused = 0;
  for (const std::string& wrong : with_wrong_bytes(content_of(file), 60)) {
    write_bytes(file, wrong);
    if (const auto read = read_patterns(file, digest, kMembers))
      ask_everywhere(*read);
    else
      ++refused;
  }
  CHECK(refused >= 25);
}

TEST_CASE("the patterns of a large map are kept in one file, and come from there the next time") {
  const TemporaryFolder folder;
  const auto patterns = some_patterns();
  const PatternCache cache(folder.path_of("prepared"), kMembers);
  CHECK(same(cache.index_of(each_of(patterns), kMembers), PatternIndex(patterns)));
  const auto files = files_in(folder.path_of("prepared"));
  REQUIRE(files.size() == 1);
  CHECK(files[0].extension() == ".patterns");
  const std::string kept = content_of(files[0]);
  CHECK(same(cache.index_of(each_of(patterns), kMembers), PatternIndex(patterns)));
  CHECK(files_in(folder.path_of("prepared")) == files);
  write_bytes(files[0], "no patterns");
  CHECK(same(cache.index_of(each_of(patterns), kMembers), PatternIndex(patterns)));
  CHECK(content_of(files[0]) == kept);
}

TEST_CASE("patterns of small maps are not kept, and those without a folder neither") {
  const TemporaryFolder folder;
  const auto patterns = some_patterns();
  CHECK(same(PatternCache(folder.path()).index_of(each_of(patterns), kMembers), PatternIndex(patterns)));
  CHECK(same(PatternCache({}, 1).index_of(each_of(patterns), kMembers), PatternIndex(patterns)));
  CHECK(files_in(folder.path()).empty());
}

TEST_CASE("who looks patterns of a large map up keeps them where the map is kept") {
  const TemporaryFolder folder;
  std::vector<Feature> features;
  for (int row = 0; features.size() < PatternCache::kLargeMap; ++row)
    for (int k = 0; k < 100; ++k) features.push_back(column(3.0 * k, 4.0 * row));
  const auto map = map_of(features);
  const std::vector<Named<PatternTemplate>> templates{{"opal:ColumnPair", shipped("opal:ColumnPair")}};
  const auto kept = std::make_shared<const MapView>(map, "lidar", folder.path());
  CHECK(kept->kept_in() == folder.path());
  const auto patterns_in = [](const fs::path& where) {
    std::vector<fs::path> files = files_in(where);
    std::erase_if(files, [](const fs::path& file) { return file.extension() != ".patterns"; });
    return files;
  };
  CHECK(patterns_in(folder.path()).empty());
  const CandidateGenerator written(kept, templates, {});
  const auto files = patterns_in(folder.path());
  REQUIRE(files.size() == 1);
  CHECK(fs::file_size(files[0]) > 10000);
  const CandidateGenerator read(kept, templates, {});
  CHECK(patterns_in(folder.path()) == files);
}

TEST_CASE("a tree whose arrays do not belong together is not sound") {
  constexpr std::size_t kPatterns = 40, kDimensions = 3;
  std::mt19937 random(3);
  std::vector<float> values(kPatterns * kDimensions);
  for (float& value : values) value = static_cast<float>(random() % 100);
  const InvariantTree tree(kPatterns, kDimensions, values);
  const auto copied = [](const auto& array) { return std::vector(array.values().begin(), array.values().end()); };
  const auto is_sound = [&](const auto& change) {
    auto order = copied(tree.arrays().order);
    auto invariants = copied(tree.arrays().values);
    auto boxes = copied(tree.arrays().boxes);
    change(order, invariants, boxes);
    const InvariantTree::Arrays arrays{ReadOnlyArray(std::move(order)), ReadOnlyArray(std::move(invariants)),
                                       ReadOnlyArray(std::move(boxes))};
    return InvariantTree::are_sound(kPatterns, kDimensions, arrays);
  };
  CHECK(is_sound([](auto&, auto&, auto&) {}));
  CHECK_FALSE(is_sound([](auto& order, auto&, auto&) { order.pop_back(); }));
  CHECK_FALSE(is_sound([](auto& order, auto&, auto&) { order[7] = -1; }));
  CHECK_FALSE(is_sound([](auto& order, auto&, auto&) { order[7] = kPatterns; }));
  CHECK_FALSE(is_sound([](auto&, auto& invariants, auto&) { invariants.pop_back(); }));
  CHECK_FALSE(is_sound([](auto&, auto&, auto& boxes) { boxes.pop_back(); }));
  CHECK_FALSE(is_sound([](auto&, auto&, auto& boxes) { boxes.push_back(boxes.back()); }));
}
