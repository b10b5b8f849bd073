#include "cli/calibration/judged_runs.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/options/verbs.hpp"

#include <opal/common/error.hpp>
#include "common/phrases.hpp"
#include "common/text_file.hpp"
#include "evaluation/calibration_page.hpp"
#include "output/output_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iostream>

namespace opal::cli {
namespace {

struct CalibrationOptions {
  std::vector<std::string> runs;
  std::string truth, out;
  PoseTolerance right = kRightPose;
};

CalibrationChapter chapter_of(const std::string& title, std::span<const Statement> statements) {
  return {title, calibration_of(statements, Weighting::per_statement),
          calibration_of(statements, Weighting::per_cluster)};
}

void print(const CalibrationChapter& chapter) {
  std::cout << chapter.title << '\n'
            << markdown_of(table_of(chapter.per_statement)) << "every row counts the same\n"
            << scores_of(chapter.per_statement) << "every query counts the same\n"
            << scores_of(chapter.per_cluster) << '\n';
}

nlohmann::ordered_json both(const CalibrationChapter& chapter) {
  return {{"per_row", to_json(chapter.per_statement)}, {"per_query", to_json(chapter.per_cluster)}};
}

nlohmann::ordered_json json_of(const JudgedRuns& runs, const std::vector<CalibrationChapter>& chapters) {
  const Interval queries = wilson_interval(runs.share_of_queries_with_false_flag(), double(runs.queries));
  return {{"runs", runs.runs},
          {"queries", runs.queries},
          {"rows", runs.rows},
          {"flagged_rows", runs.flagged_rows},
          {"false_rows", runs.false_rows},
          {"flagged_queries", runs.flagged_queries},
          {"false_queries", runs.false_queries},
          {"false_queries_95", {queries.low, queries.high}},
          {"best", both(chapters[0])},
          {"all_places", both(chapters[1])},
          {"none", both(chapters[2])}};
}

std::string queries_in_words(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "query" : "queries");
}

std::string flags_of(const JudgedRuns& runs) {
  const double share = runs.share_of_queries_with_false_flag();
  const Interval queries = wilson_interval(share, double(runs.queries));
  return fmt::format(
      "{} of {} in {}\n"
      "flagged as localized: {} rows, {} of them wrong ({:.3f} %); {} queries\n"
      "queries with a wrong flag: {} of {}, {:.1f} % (95 %: {:.1f} to {:.1f})\n",
      count_of(runs.rows, "row"), queries_in_words(runs.queries), count_of(runs.runs, "run"), runs.flagged_rows,
      runs.false_rows, runs.flagged_rows ? 100.0 * double(runs.false_rows) / double(runs.flagged_rows) : 0.0,
      runs.flagged_queries, runs.false_queries, runs.queries, 100 * share, 100 * queries.low, 100 * queries.high);
}

int calibrate(const CalibrationOptions& options) {
  JudgedRuns runs;
  for (const std::string& run : options.runs) {
    if (const std::string note = unfinished_note(run); !note.empty())
      std::cerr << "opal: " << run << ": " << note << '\n';
    runs.add(run, options.truth, options.right);
  }
  const std::string flags = flags_of(runs);
  const std::vector<CalibrationChapter> chapters{chapter_of("the best place is right", runs.best),
                                                 chapter_of("a place is right, best or alternative", runs.places),
                                                 chapter_of("none of the places is right", runs.none)};
  std::cout << flags << '\n';
  for (const CalibrationChapter& chapter : chapters) print(chapter);
  if (options.out.empty()) return kDone;
  OutputFolder folder(options.out, "opal calibration", {"calibration.json", "report.html"});
  write_text(folder.file("calibration.json"), json_of(runs, chapters).dump(2) + '\n');
  write_text(folder.file("report.html"), calibration_page(flags, chapters));
  std::cout << "written: calibration.json and report.html in " << options.out << '\n';
  folder.finish();
  return kDone;
}

}  // namespace

void add_calibration_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CalibrationOptions>();
  CLI::App* verb = app.add_subcommand("calibration", "how far the probabilities of bench runs can be trusted");
  verb->add_option("RUN", options->runs, "folders that opal bench wrote")->required();
  verb->add_option("-o,--out", options->out, "folder for calibration.json and report.html");
  verb->add_option("--truth", options->truth, "folder that holds SITE.gt.csv (default: where the run's recording was)");
  verb->add_option("--within", options->right.position_m, "a pose with smaller errors is right: of the position [m]")
      ->capture_default_str()
      ->check(above_zero());
  auto heading_deg = std::make_shared<double>(degrees(kRightPose.heading_rad));
  verb->add_option("--within-degrees", *heading_deg, "and of the heading [degrees]")
      ->capture_default_str()
      ->check(above_zero());
  verb->callback([options, heading_deg, &exit_code] {
    options->right.heading_rad = radians(*heading_deg);
    exit_code = calibrate(*options);
  });
}

}  // namespace opal::cli
