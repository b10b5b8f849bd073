#pragma once

#include "benchmark/experiments/kit/thesis_table.hpp"
#include "benchmark/experiments/kit/time_plot.hpp"
#include "cli/terminal/stop_signals.hpp"

#include "common/text_file.hpp"
#include "drawing/figure.hpp"
#include "report/table_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

namespace opal::cli {

/// What the experiments of the thesis leave in their folder.
inline std::vector<std::string> experiment_products() {
  return {"runs.csv", "table.*", "summary.json", "report.html", "figure_*"};
}

/// The signal that has left some part undone; 0 if all are done.
template <class Run>
int cut_by(const StopSignals& signals, const std::vector<std::vector<Run>>& parts) {
  const bool is_whole = std::none_of(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); });
  return is_whole ? 0 : signals.signal();
}

/// All that was done; says so if a stop has left some undone.
template <class Run>
std::vector<Run> done(std::vector<std::vector<Run>> parts) {
  std::vector<Run> runs;
  const auto undone = std::count_if(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); });
  if (undone > 0)
    std::cerr << "stopped: " << undone << " of " << parts.size()
              << " runs were not done, what follows is of the others\n";
  for (std::vector<Run>& part : parts) std::move(part.begin(), part.end(), std::back_inserter(runs));
  return runs;
}

/// The runs of the first seed over time, as in a paper: figure_CONTENDER_NAME.svg and .pdf.
/// @param name  of what a run does: its challenge, its task.
template <class Run>
void write_time_figures(const std::filesystem::path& folder, std::span<const Run> runs, std::string Run::*name) {
  for (const Run& run : runs)
    if (run.seed == runs.front().seed && !run.moments.empty())
      write_figure((folder / ("figure_" + run.contender + '_' + run.*name)).string(),
                   experiments::lines_over_time(run.moments));
}

/// Leaves runs.csv, summary.json, report.html, the table and figures in a folder, and the table on stdout.
template <class Run>
void write_experiment(const std::string& out, std::span<const Run> runs, std::string Run::*name,
                      const experiments::ThesisTable& table, const nlohmann::ordered_json& summary,
                      const std::string& page) {
  const std::filesystem::path folder(out);
  std::ostringstream csv;
  write_runs(csv, runs);
  const std::string text = text_of(table);
  write_text((folder / "runs.csv").string(), csv.str());
  write_text((folder / "table.txt").string(), text);
  write_text((folder / "summary.json").string(), summary.dump(1) + '\n');
  write_text((folder / "report.html").string(), page);
  write_table((folder / "table").string(), rows_of(table));
  write_time_figures(folder, runs, name);
  std::cout << text << "written: runs.csv, table.txt, table.*, summary.json, report.html, figure_* in " << out << '\n';
}

/// What `write_drives` leaves.
inline std::vector<std::string> drive_products() { return {"drives.*", "table.*"}; }

/// Leaves a table and a row a drive in a folder.
inline void write_drives(const std::string& out, const Table& table, const Table& rows) {
  const std::filesystem::path folder(out);
  write_text((folder / "table.txt").string(), markdown_of(table));
  write_table((folder / "table").string(), table);
  write_text((folder / "drives.csv").string(), csv_of(rows));
  std::cout << "written: drives.csv, table.txt, table.* in " << out << '\n';
}

}  // namespace opal::cli
