#include "small_experiment.hpp"

#include "benchmark/ab/records/journal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal::ab;
using opal::TemporaryFolder;
using opal::ab_tests::content_of;

namespace {

CellResult result_of(std::size_t number) {
  return {number,
          "00ff",
          {{"success", 1}, {"distance_to_success_m", 0.1 * double(number)}},
          {{"cpu_ms", 1.5}},
          number % 2 ? "crashed \"so\"\n" : ""};
}

std::vector<std::size_t> numbers_in(const std::string& path) {
  std::vector<std::size_t> numbers;
  read_journal(path, [&](const CellResult& result, JournalPlace) { numbers.push_back(result.number); });
  return numbers;
}

}  // namespace

TEST_CASE("what a journal is given comes back") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("journal.jsonl");
  {
    Journal journal(path);
    for (std::size_t k = 0; k < 3; ++k) journal.append(result_of(k));
  }
  std::size_t k = 0;
  read_journal(path, [&](const CellResult& result, JournalPlace place) {
    const CellResult expected = result_of(k++);
    CHECK(result.number == expected.number);
    CHECK(result.input == expected.input);
    CHECK(result.values == expected.values);
    CHECK(result.costs == expected.costs);
    CHECK(result.failure == expected.failure);
    CHECK(content_of(path).substr(place.offset, place.length) == journal_line(expected));
  });
  CHECK(k == 3);
}

TEST_CASE("a journal that was cut anywhere holds the cells before the cut, and goes on after them") {
  const TemporaryFolder folder;
  std::string whole;
  for (std::size_t k = 0; k < 3; ++k) whole += journal_line(result_of(k)) + "\n";
  for (std::size_t cut = 0; cut <= whole.size(); cut += 9) {
    CAPTURE(cut);
    const std::string path = folder.write("journal.jsonl", whole.substr(0, cut));
    std::vector<std::size_t> expected;
    for (std::size_t k = 0, end = 0; k < 3; ++k) {
      end = whole.find('\n', end) + 1;
      if (end <= cut) expected.push_back(k);
    }
    REQUIRE(numbers_in(path) == expected);
    Journal(path).append(result_of(7));
    expected.push_back(7);
    REQUIRE(numbers_in(path) == expected);
  }
}

TEST_CASE("a damaged line is named, and not taken for a result") {
  const TemporaryFolder folder;
  std::string text = journal_line(result_of(0)) + "\n" + journal_line(result_of(2)) + "\n";
  text[text.size() / 2 + 60] ^= 1;
  const std::string path = folder.write("journal.jsonl", text);
  CHECK_THROWS_WITH(numbers_in(path), Catch::StartsWith(path + ": line 2: damaged, expected a finished cell"));
}
