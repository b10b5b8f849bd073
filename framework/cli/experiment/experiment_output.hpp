#pragma once

#include "benchmark/experiments/kit/thesis_table.hpp"

#include <opal/common/error.hpp>
#include "common/text_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

/// All that was done. @throws opal::Error if nothing was.
template <class Run>
std::vector<Run> done(std::vector<std::vector<Run>> parts) {
  std::vector<Run> runs;
  const auto undone = std::count_if(parts.begin(), parts.end(), [](const auto& part) { return part.empty(); });
  if (undone > 0)
    std::cerr << "stopped: " << undone << " of " << parts.size()
              << " runs were not done, what follows is of the others\n";
  for (std::vector<Run>& part : parts) std::move(part.begin(), part.end(), std::back_inserter(runs));
  if (runs.empty()) throw opal::Error("experiment: stopped before the first run was done");
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
