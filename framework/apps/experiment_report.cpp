#include "experiment_report.hpp"

#include <opal/drawing.hpp>
#include <opal/error.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <sstream>

namespace {

using Runs = std::vector<const ExperimentRun*>;

/// Names in order of appearance.
std::vector<std::string> names(std::span<const ExperimentRun> runs, std::string ExperimentRun::*name) {
  std::vector<std::string> all;
  for (const ExperimentRun& run : runs)
    if (std::find(all.begin(), all.end(), run.*name) == all.end()) all.push_back(run.*name);
  return all;
}

Runs of(std::span<const ExperimentRun> runs, const std::string& contender, const std::string& challenge) {
  Runs chosen;
  for (const ExperimentRun& run : runs)
    if (run.contender == contender && (challenge.empty() || run.challenge == challenge)) chosen.push_back(&run);
  return chosen;
}

std::string number(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// Median of what is not negative; "-" if nothing is.
std::string median(const Runs& runs, const std::function<double(const ExperimentRun&)>& value, int decimals) {
  std::vector<double> values;
  for (const ExperimentRun* run : runs)
    if (value(*run) >= 0) values.push_back(value(*run));
  if (values.empty()) return "-";
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return number(values[values.size() / 2], decimals);
}

int count(const Runs& runs, const std::function<bool(const ExperimentRun&)>& holds) {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), [&](const ExperimentRun* run) { return holds(*run); }));
}

struct Measure {
  const char* name;
  std::function<std::string(const Runs&)> of;
};

std::string share_of(int part, std::size_t whole) { return std::to_string(part) + "/" + std::to_string(whole); }

const std::vector<Measure>& measures() {
  using Run = ExperimentRun;
  static const std::vector<Measure> all{
      {"successful", [](const Runs& r) { return share_of(count(r, [](const Run& x) { return x.success; }), r.size()); }},
      {"distance ML m", [](const Runs& r) { return median(r, [](const Run& x) { return x.right_after_m; }, 1); }},
      {"self-reported", [](const Runs& r) { return share_of(count(r, [](const Run& x) { return x.localized_after_m >= 0; }), r.size()); }},
      {"self-rep. distance m", [](const Runs& r) { return median(r, [](const Run& x) { return x.localized_after_m; }, 1); }},
      {"falsely so", [](const Runs& r) { return share_of(count(r, [](const Run& x) { return x.false_rows > 0; }), r.size()); }},
      {"ML error after m", [](const Runs& r) { return median(r, [](const Run& x) { return x.error_m; }, 2); }},
      {"max hyp. before", [](const Runs& r) { return median(r, [](const Run& x) { return x.hypotheses_before; }, 0); }},
      {"max hyp. after", [](const Runs& r) { return median(r, [](const Run& x) { return x.localized_after_m < 0 ? -1 : x.hypotheses_after; }, 0); }},
      {"CPU ms per update", [](const Runs& r) { return median(r, [](const Run& x) { return x.cpu_ms; }, 2); }}};
  return all;
}

std::string wilson(int part, std::size_t whole) {
  constexpr double z = 1.96;
  const double n = static_cast<double>(whole), p = part / n, z2 = z * z;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = z / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return number(100 * p, 1) + " % (95 %: " + number(100 * (middle - half), 1) + " to " + number(100 * (middle + half), 1) + ")";
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// One way per challenge, numbered by the order of the table.
std::string ways_as_svg(const opal::SemanticMap& map, std::span<const ExperimentRun> runs, const std::string& folder) {
  std::string svgs;
  for (const std::string& challenge : names(runs, &ExperimentRun::challenge)) {
    const auto run = std::find_if(runs.begin(), runs.end(), [&](const ExperimentRun& r) { return r.challenge == challenge; });
    opal::DrawingScene scene;
    scene.title = challenge;
    scene.map = std::shared_ptr<const opal::SemanticMap>(std::shared_ptr<void>(), &map);
    scene.truth = run->truth;
    const std::string file = folder + "/way_" + challenge + ".svg";
    opal::write_svg(scene, file);
    svgs += "<figure>" + content_of(file) + "</figure>\n";
  }
  return svgs;
}

}  // namespace

std::string experiment_table(std::span<const ExperimentRun> runs) {
  const auto challenges = names(runs, &ExperimentRun::challenge);
  std::ostringstream table;
  const auto cell = [&](const std::string& text, int width) { table << text << std::string(text.size() < static_cast<std::size_t>(width) ? width - text.size() : 1, ' '); };
  for (const std::string& contender : names(runs, &ExperimentRun::contender)) {
    cell(contender, 24);
    for (const std::string& challenge : challenges) cell(challenge, 8);
    table << '\n';
    for (const Measure& measure : measures()) {
      cell("  " + std::string(measure.name), 24);
      for (const std::string& challenge : challenges) cell(measure.of(of(runs, contender, challenge)), 8);
      table << '\n';
    }
    const Runs all = of(runs, contender, "");
    long rows = 0, wrong = 0;
    for (const ExperimentRun* run : all) rows += run->localized_rows, wrong += run->false_rows;
    table << "  all: successful " << wilson(count(all, [](const ExperimentRun& r) { return r.success; }), all.size())
          << "; said localized and was wrong at some time in " << wilson(count(all, [](const ExperimentRun& r) { return r.false_rows > 0; }), all.size())
          << ", " << wrong << " of " << rows << " scans\n\n";
  }
  return table.str();
}

void write_runs(std::ostream& out, std::span<const ExperimentRun> runs) {
  out << "contender,challenge,seed,success,right_after_m,localized_after_m,error_m,hypotheses_before,hypotheses_after,updates,"
         "localized_rows,false_rows,cpu_ms\n";
  for (const ExperimentRun& r : runs)
    out << r.contender << ',' << r.challenge << ',' << r.seed << ',' << r.success << ',' << number(r.right_after_m, 2) << ','
        << number(r.localized_after_m, 2) << ',' << number(r.error_m, 3) << ',' << r.hypotheses_before << ',' << r.hypotheses_after
        << ',' << r.updates << ',' << r.localized_rows << ',' << r.false_rows << ',' << number(r.cpu_ms, 3) << '\n';
}

void write_experiment_page(const std::string& path, const std::string& title, const std::string& table,
                           const opal::SemanticMap& map, std::span<const ExperimentRun> runs) {
  std::ofstream file(path);
  file << "<!doctype html><html lang=en><meta charset=utf-8><title>" << escaped(title) << "</title><style>"
       << "body{font:15px/1.5 sans-serif;margin:2rem}pre{font:13px/1.4 monospace;overflow-x:auto}figure{display:inline-block;"
          "width:30rem;margin:.5rem}figure svg{width:100%;height:auto}</style><h1>"
       << escaped(title) << "</h1>\n<p>Success, distances, errors and hypotheses as in Hendrikx (2023), 3.5.5; medians over the seeds.</p>\n<pre>"
       << escaped(table) << "</pre>\n<h2>The ways (first seed)</h2>\n"
       << ways_as_svg(map, runs, std::filesystem::path(path).parent_path().string()) << "</html>\n";
  if (!file) throw opal::Error(path + ": cannot be written");
}
