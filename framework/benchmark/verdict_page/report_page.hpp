#pragma once

#include "benchmark/verdict/results_table.hpp"
#include "benchmark/verdict/verdict.hpp"

#include <functional>

namespace opal::statistics {

/// All that a third party needs to see what was found, and to find it again.
struct ReportPage {
  struct Version {
    std::string name, version, file_hash;  ///< of the program or a plugin
  };

  std::string title;
  std::vector<Verdict> verdicts;
  ResultsTable table;
  std::string configuration;      ///< the whole of it, JSON text
  std::vector<Version> versions;  ///< of what took part
  std::string command;            ///< that runs it again
  /// Where the run behind a row is shown, relative to the page; empty if nowhere.
  std::function<std::string(const ResultRow&)> link;
};

/// One self-contained HTML file; nothing in it is fetched.
std::string to_html(const ReportPage& page);

}  // namespace opal::statistics
