#pragma once

#include "benchmark/experiments/kit/thesis_table.hpp"
#include "cli/terminal/stop_signals.hpp"

#include "common/text_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

/// What the experiments of the thesis leave in their folder.
inline std::vector<std::string> experiment_products() {
  return {"runs.csv", "table.txt", "summary.json", "report.html"};
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

/// Leaves runs.csv, table.txt, summary.json and report.html in a folder, and the table on stdout.
template <class Runs>
void write_experiment(const std::string& out, const Runs& runs, const opal::experiments::ThesisTable& table,
                      const nlohmann::ordered_json& summary, const std::string& page) {
  const std::filesystem::path folder(out);
  std::ostringstream csv;
  write_runs(csv, runs);
  const std::string text = text_of(table);
  opal::write_text((folder / "runs.csv").string(), csv.str());
  opal::write_text((folder / "table.txt").string(), text);
  opal::write_text((folder / "summary.json").string(), summary.dump(1) + '\n');
  opal::write_text((folder / "report.html").string(), page);
  std::cout << text << "written: runs.csv, table.txt, summary.json, report.html in " << out << '\n';
}

/// Leaves a table and a row a drive in a folder.
inline void write_drives(const std::string& out, const std::string& table, const std::string& rows) {
  opal::write_text((std::filesystem::path(out) / "table.txt").string(), table);
  opal::write_text((std::filesystem::path(out) / "drives.csv").string(), rows);
  std::cout << "written: drives.csv, table.txt in " << out << '\n';
}
