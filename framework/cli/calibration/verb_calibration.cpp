#include "cli/calibration/judged_runs.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/verbs.hpp"

#include <opal/common/error.hpp>
#include "common/text_file.hpp"
#include "drawing/reliability_diagram.hpp"
#include "evaluation/calibration.hpp"
#include "output/output_folder.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <numbers>

namespace {

using opal::Weighting;
constexpr double kDegrees = 180 / std::numbers::pi;  // of a radian

struct CalibrationOptions {
  std::vector<std::string> runs;
  std::string truth, out;
  opal::PoseTolerance right;
};

void print(const std::string& what, std::span<const opal::Statement> statements) {
  const opal::Calibration by_row = calibration_of(statements, Weighting::per_statement);
  std::cout << what << '\n'
            << table_of(by_row) << "every row counts the same\n"
            << scores_of(by_row) << "every query counts the same\n"
            << scores_of(calibration_of(statements, Weighting::per_cluster)) << '\n';
}

nlohmann::ordered_json both(std::span<const opal::Statement> statements) {
  return {{"per_row", to_json(calibration_of(statements, Weighting::per_statement))},
          {"per_query", to_json(calibration_of(statements, Weighting::per_cluster))}};
}

nlohmann::ordered_json json_of(const JudgedRuns& runs) {
  const opal::Interval queries = opal::wilson_interval(runs.share_of_queries_with_false_flag(), double(runs.queries));
  return {{"runs", runs.runs},
          {"queries", runs.queries},
          {"rows", runs.rows},
          {"flagged_rows", runs.flagged_rows},
          {"false_rows", runs.false_rows},
          {"flagged_queries", runs.flagged_queries},
          {"false_queries", runs.false_queries},
          {"false_queries_95", {queries.low, queries.high}},
          {"best", both(runs.best)},
          {"all_places", both(runs.places)},
          {"none", both(runs.none)}};
}

void print_flags(const JudgedRuns& runs) {
  const opal::Interval queries = opal::wilson_interval(runs.share_of_queries_with_false_flag(), double(runs.queries));
  char text[400];
  std::snprintf(text, sizeof text,
                "%zu rows of %zu queries in %zu runs\n"
                "flagged as localized: %zu rows, %zu of them wrong (%.3f %%); %zu queries\n"
                "queries with a wrong flag: %zu of %zu, %.1f %% (95 %%: %.1f to %.1f)\n\n",
                runs.rows, runs.queries, runs.runs, runs.flagged_rows, runs.false_rows,
                runs.flagged_rows ? 100.0 * double(runs.false_rows) / double(runs.flagged_rows) : 0.0,
                runs.flagged_queries, runs.false_queries, runs.queries, 100 * runs.share_of_queries_with_false_flag(),
                100 * queries.low, 100 * queries.high);
  std::cout << text;
}

int calibrate(const CalibrationOptions& options) {
  JudgedRuns runs;
  for (const std::string& run : options.runs) {
    if (const std::string note = opal::unfinished_note(run); !note.empty())
      std::cerr << "opal: " << run << ": " << note << '\n';
    runs.add(run, options.truth, options.right);
  }
  print_flags(runs);
  print("the best place is right", runs.best);
  print("a place is right, best or alternative", runs.places);
  print("none of the places is right", runs.none);
  if (options.out.empty()) return kDone;
  opal::OutputFolder folder(options.out, "opal calibration",
                            {"calibration.json", "reliability.svg", "reliability.png"});
  opal::write_text(folder.file("calibration.json"), json_of(runs).dump(2) + '\n');
  const opal::Calibration best = calibration_of(runs.best, Weighting::per_statement);
  const std::string title = "The best place is right: said and come true";
  write_reliability_svg(best, title, folder.file("reliability.svg"));
  write_reliability_png(best, title, folder.file("reliability.png"));
  std::cout << "written: calibration.json, reliability.svg and reliability.png in " << options.out << '\n';
  folder.finish();
  return kDone;
}

}  // namespace

void opal::add_calibration_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CalibrationOptions>();
  CLI::App* verb = app.add_subcommand("calibration", "how far the probabilities of bench runs can be trusted");
  verb->add_option("RUN", options->runs, "folders that opal bench wrote")->required();
  verb->add_option("-o,--out", options->out, "folder for calibration.json and the reliability diagram");
  verb->add_option("--truth", options->truth, "folder that holds SITE.gt.csv (default: where the run's recording was)");
  verb->add_option("--within", options->right.position_m, "a pose with smaller errors is right: of the position [m]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  auto heading_deg = std::make_shared<double>(opal::kRightPose.heading_rad * kDegrees);
  verb->add_option("--within-degrees", *heading_deg, "and of the heading [degrees]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->callback([options, heading_deg, &exit_code] {
    options->right.heading_rad = *heading_deg / kDegrees;
    exit_code = calibrate(*options);
  });
}
