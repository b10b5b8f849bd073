#pragma once

#include <experiments/table.hpp>

#include <opal/text_file.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <sstream>

/// Leaves runs.csv, table.txt, summary.json and report.html in a folder, and the table on stdout.
template <class Runs>
void write_experiment(const std::string& out, const Runs& runs, const opal::experiments::Table& table, const nlohmann::ordered_json& summary,
                      const std::string& page) {
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
