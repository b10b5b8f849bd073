#include "benchmark/experiments/challenges/challenge_report.hpp"

#include "benchmark/experiments/kit/by_name.hpp"
#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/experiments/kit/published.hpp"
#include "benchmark/experiments/kit/summary_json.hpp"

#include <functional>
#include <ostream>

namespace opal::experiments {
namespace {

using Run = ChallengeRun;
using Runs = std::vector<const Run*>;

/// A number of one run, if it has one.
struct Measure {
  const char* name;
  std::function<std::optional<double>(const Run&)> of;
  int decimals;
};

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"distance ML m", &Run::right_after_m, 1},
      {"self-rep. distance m", &Run::localized_after_m, 1},
      {"ML error after m", &Run::error_m, 2},
      {"max hyp. before", &Run::hypotheses_before, 0},
      {"max hyp. after",
       [](const Run& r) { return r.localized_after_m ? std::optional<double>(r.hypotheses_after) : std::nullopt; }, 0},
      {"CPU ms per update", &Run::cpu_ms, 2}};
  return all;
}

struct Share {
  const char* name;
  std::function<bool(const Run&)> holds;
};

const std::vector<Share>& shares() {
  static const std::vector<Share> all{{"successful", &Run::success},
                                      {"self-reported", [](const Run& r) { return r.localized_after_m.has_value(); }},
                                      {"falsely so", [](const Run& r) { return r.false_rows > 0; }}};
  return all;
}

std::vector<double> known(const Runs& runs, const Measure& measure) {
  std::vector<double> all;
  for (const Run* run : runs)
    if (const auto value = measure.of(*run)) all.push_back(*value);
  return all;
}

std::string about_all(const Runs& all) {
  long rows = 0, wrong = 0;
  for (const Run* run : all) rows += run->localized_rows, wrong += run->false_rows;
  return "successful " + share_text(count(all, shares()[0].holds), all.size()) +
         "; said localized and was wrong at some time in " + share_text(count(all, shares()[2].holds), all.size()) +
         ", " + std::to_string(wrong) + " of " + std::to_string(rows) + " scans";
}

ThesisTable::Block block_of(std::span<const Run> runs, const std::string& contender,
                            const std::vector<std::string>& challenges) {
  ThesisTable::Block block{contender, {}, about_all(those_of(runs, contender, &Run::challenge))};
  const auto row = [&](const char* name, const std::function<std::string(const Runs&)>& cell) {
    block.rows.push_back({name, {}});
    for (const std::string& challenge : challenges)
      block.rows.back().cells.push_back(cell(those_of(runs, contender, &Run::challenge, challenge)));
  };
  for (const Share& share : shares())
    row(share.name, [&](const Runs& r) { return share_of(count(r, share.holds), r.size()); });
  for (const Measure& measure : measures())
    row(measure.name, [&](const Runs& r) { return number(median(known(r, measure)), measure.decimals); });
  return block;
}

nlohmann::ordered_json summary_of(const Runs& runs) {
  nlohmann::ordered_json summary = {{"runs", runs.size()}};
  for (const Share& share : shares()) summary[share.name] = share_json(count(runs, share.holds), runs.size());
  for (const Measure& measure : measures()) {
    const std::vector<double> numbers = known(runs, measure);
    summary[measure.name] = {{"runs", numbers.size()}};
    summary[measure.name].update(median_json(numbers));
  }
  return summary;
}

}  // namespace

ThesisTable challenge_table(std::span<const Run> runs) {
  ThesisTable table{names(runs, &Run::challenge), {}};
  for (const ThesisTable::Block& published : table_3_3())
    table.blocks.push_back(with_columns(published, table_3_3_columns(), table.columns));
  for (const std::string& contender : names(runs, &Run::contender))
    table.blocks.push_back(block_of(runs, contender, table.columns));
  return table;
}

nlohmann::ordered_json challenge_summary(std::span<const Run> runs) {
  return summary_by(runs, &Run::challenge, [](const Runs& some, const std::string&) { return summary_of(some); });
}

void write_runs(std::ostream& out, std::span<const Run> runs) {
  out << "contender,challenge,seed,success,right_after_m,localized_after_m,error_m,hypotheses_before,"
         "hypotheses_after,updates,"
         "localized_rows,false_rows,cpu_ms\n";
  for (const Run& r : runs)
    out << r.contender << ',' << r.challenge << ',' << r.seed << ',' << r.success << ','
        << number(r.right_after_m.value_or(-1), 2) << ',' << number(r.localized_after_m.value_or(-1), 2) << ','
        << number(r.error_m.value_or(-1), 3) << ',' << r.hypotheses_before << ',' << r.hypotheses_after << ','
        << r.updates << ',' << r.localized_rows << ',' << r.false_rows << ',' << number(r.cpu_ms, 3) << '\n';
}

}  // namespace opal::experiments
