#include "benchmark/ab/records/merged_results.hpp"

#include <opal/common/error.hpp>
#include "common/whole_file.hpp"

#include <fmt/format.h>

#include <fstream>

namespace opal::ab {
namespace {

using nlohmann::ordered_json;

bool same(const CellResult& a, const CellResult& b) {
  return a.input == b.input && a.values == b.values && a.failure == b.failure;
}

/// What an arm that failed was given on the way is not known.
bool same_input(const CellResult& a, const CellResult& b) {
  const bool both = a.failure.empty() && b.failure.empty();
  const std::size_t known = both ? std::string::npos : std::min(a.input.size(), b.input.size());
  return a.input.substr(0, known) == b.input.substr(0, known);
}

/// What two arms were given, behind a slash what hypotheses they judged.
std::string difference(const std::string& a, const std::string& input_a, const std::string& b,
                       const std::string& input_b) {
  const auto given = [](const std::string& input) { return input.substr(0, input.find('/')); };
  if (given(input_a) == given(input_b))
    return a + " and " + b +
           " judge different hypotheses of the same log, expected the same: a detector or pattern in " +
           "the plugin folder of one arm runs in that arm only; give all arms the folder, or name detectors and "
           "patterns";
  return a + " was given input " + input_a + " and " + b + " " + input_b +
         ", expected the same map and log for all arms";
}

void write_line(WholeFile& file, const ordered_json& line) {
  file.write(line.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + '\n');
}

}  // namespace

MergedResults::MergedResults(const ResultFolder& folder, const CellPlan& plan)
    : folder_(folder), plan_(plan), journals_(folder.journals()), places_(plan.cells()) {
  for (std::uint32_t k = 0; k < journals_.size(); ++k)
    read_journal(journals_[k], [&](const CellResult& result, JournalPlace place) { add(k, result, place); });
  expect_equal_inputs();
}

void MergedResults::add(std::uint32_t journal, const CellResult& result, const JournalPlace& place) {
  if (result.number >= places_.size())
    throw Error(
        fmt::format("{}: holds cell {}, which the experiment does not have", journals_[journal], result.number));
  Place& known = places_[result.number];
  if (known.length > 0) {
    if (same(read(known), result)) return;
    throw Error(journals_[journal] + ": cell " + plan_.name(plan_.cell(result.number)) +
                " came out differently than in " + journals_[known.journal] +
                ", expected the same result from the same cell");
  }
  known = {place.offset, place.length, journal};
  ++finished_;
}

CellResult MergedResults::read(const Place& place) const {
  if (open_journal_ != place.journal) {
    open_file_ = std::ifstream(journals_[place.journal], std::ios::binary);
    open_journal_ = place.journal;
  }
  std::string line(place.length, '\0');
  open_file_.clear();
  open_file_.seekg(static_cast<std::streamoff>(place.offset)).read(line.data(), place.length);
  return parse_journal_line(line, journals_[place.journal]);
}

void MergedResults::for_each(const std::function<void(const Cell&, const CellResult&)>& take) const {
  for (std::size_t number = 0; number < places_.size(); ++number)
    if (places_[number].length > 0) take(plan_.cell(number), read(places_[number]));
}

void MergedResults::for_each_complete_task(const std::function<void(const Cell&, const CellResult&)>& take) const {
  const auto complete_task = [&](std::size_t task) {
    for (std::size_t arm = 0; arm < plan_.arms(); ++arm)
      if (places_[task * plan_.arms() + arm].length == 0) return false;
    return true;
  };
  for (std::size_t task = 0; task < plan_.tasks(); ++task) {
    if (!complete_task(task)) continue;
    for (std::size_t number = task * plan_.arms(); number < (task + 1) * plan_.arms(); ++number)
      take(plan_.cell(number), read(places_[number]));
  }
}

void MergedResults::expect_equal_inputs() const {
  CellResult before;  // the one of this task that tells most of its input
  for_each([&](const Cell& cell, const CellResult& result) {
    const bool same_task = before.number / plan_.arms() == result.number / plan_.arms();
    if (!before.input.empty() && same_task && !same_input(before, result))
      throw Error(folder_.path() + ": " +
                  difference(plan_.name(plan_.cell(before.number)), before.input, plan_.name(cell), result.input));
    if (!same_task || before.input.empty() || (!before.failure.empty() && result.failure.empty())) before = result;
  });
}

void MergedResults::write(const std::vector<std::string>& arm_digests) const {
  WholeFile results(folder_.file("results.jsonl")), times(folder_.file("times.jsonl"));
  for_each([&](const Cell& cell, const CellResult& result) {
    write_line(results, {{"cell", plan_.name(cell)},
                         {"scenario", plan_.scenario(cell.task)},
                         {"query", plan_.query(cell.task)},
                         {"seed", cell.task.seed},
                         {"arm", plan_.arm(cell)},
                         {"arm_digest", arm_digests[cell.arm]},
                         {"input", result.input},
                         {"values", result.values},
                         {"failure", result.failure}});
    write_line(times, {{"cell", plan_.name(cell)}, {"costs", result.costs}});
  });
  results.finish();
  times.finish();
}

}  // namespace opal::ab
