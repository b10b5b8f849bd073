#include "benchmark/experiments/buildings/buildings_page.hpp"

#include "benchmark/experiments/buildings/building_picture.hpp"
#include "benchmark/experiments/kit/order_statistics.hpp"
#include "report/html_elements.hpp"
#include "report/plot.hpp"
#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::experiments {
namespace {

std::string key_html() {
  return colour_key({{"localized",
                      "localized: the best hypothesis is right (within 1 m and 10 degrees) up to the end, and was "
                      "called localized"},
                     {"unsure", "unsure: right up to the end, never called localized"},
                     {"unknown", "unknown: not right at the end, and nothing wrong was called localized"},
                     {"wrong", "wrong: a wrong pose was called localized at some time"}});
}

/// How many runs of each group of a contender ended well, or with a wrong pose.
IntervalPlot shares_plot(const BuildingsExperiment& experiment, const std::string& contender, const std::string& title,
                         const char* tone, BuildingShare BuildingGroup::*share) {
  IntervalPlot plot{
      {title, "%", false, 0.0, 100.0}, 0, {{{"group", "", false}, {"runs"}, {title + " (95 %)", "%"}}, {}}, {}};
  for (const BuildingGroup& group : experiment.groups) {
    if (group.contender != contender) continue;
    const BuildingShare& all = group.*share;
    const double at = 100 * all.share, low = 100 * all.within.low, high = 100 * all.within.high;
    plot.rows.push_back({at, low, high, tone, false});
    plot.table.rows.push_back({group.name(), std::to_string(group.runs), within_text(at, low, high, 1)});
  }
  return plot;
}

IntervalPlot success_plot(const BuildingsExperiment& experiment, const std::string& contender) {
  return shares_plot(experiment, contender, "success", "localized", &BuildingGroup::success);
}

IntervalPlot wrong_plot(const BuildingsExperiment& experiment, const std::string& contender) {
  return shares_plot(experiment, contender, "falsely localized", "wrong", &BuildingGroup::wrong);
}

std::vector<std::string> contenders_of(const BuildingsExperiment& experiment) {
  std::vector<std::string> names;
  for (const BuildingGroup& group : experiment.groups)
    if (std::find(names.begin(), names.end(), group.contender) == names.end()) names.push_back(group.contender);
  return names;
}

std::string groups_html(const BuildingsExperiment& experiment) {
  const Table table = buildings_table(experiment);
  std::string html;
  for (const std::string& contender : contenders_of(experiment))
    html += text_element("h2", contender) +
            element("section",
                    plot_html(success_plot(experiment, contender), "success in percent of the runs") +
                        plot_html(wrong_plot(experiment, contender), "falsely localized in percent of the runs")) +
            "\n";
  return text_element("h2", "All groups") +
         element("section", html_of(table) + download("buildings.csv", csv_of(table))) + "\n" + html;
}

std::string sentence_about(const ChallengeRun& run) {
  const JudgedMoment& last = run.moments.back();
  std::string text =
      fmt::format("{} (seed {}, {}): {}", run.challenge, run.seed, run.contender, name_of(outcome_of(run)));
  if (run.false_rows > 0)
    text += fmt::format("; called localized wrongly: {} of {} scans, first after {} s", run.false_rows,
                        run.moments.size(), number(wrong_after_s(run), 1));
  if (run.localized_after_m) text += fmt::format("; localized after {:.1f} m", *run.localized_after_m);
  return text + fmt::format("; at the end {}, {}; the truth has probability {:.2f}",
                            last.has_pose ? number(last.error_m(), 1) + " m off" : "no pose",
                            fmt::format("{} hypotheses", last.hypotheses), run.truth_probability);
}

struct Failure {
  const BuildingRuns* building;
  const ChallengeRun* run;
};

std::vector<Failure> failures_of(const BuildingsExperiment& experiment) {
  std::vector<Failure> failures;
  for (const BuildingRuns& building : experiment.buildings)
    for (const ChallengeRun& run : building.runs)
      if (outcome_of(run) != Outcome::localized) failures.push_back({&building, &run});
  std::stable_sort(failures.begin(), failures.end(),
                   [](const Failure& a, const Failure& b) { return outcome_of(*a.run) > outcome_of(*b.run); });
  return failures;
}

std::string failures_html(const BuildingsExperiment& experiment) {
  constexpr std::size_t kMost = 200;
  const std::vector<Failure> failures = failures_of(experiment);
  std::string html =
      text_element("h2",
                   fmt::format("Runs that were never localized, or localized at a wrong pose: {}", failures.size())) +
      (failures.size() > kMost ? text_element("p", fmt::format("The first {} of them.", kMost)) : "") + key_html() +
      text_element("p",
                   "Line: the true way, which begins at the green dot. Orange-red dots: wrong poses that were called "
                   "localized. Black ring: the best hypothesis at the end. With --record, the recordings are kept for "
                   "opal bench, localize and view.");
  std::string figures;
  for (std::size_t k = 0; k < std::min(kMost, failures.size()); ++k) {
    const auto& [building, run] = failures[k];
    figures += figure(run_picture(*building, *run) + text_element("code", command_for(experiment, *building, *run)),
                      building->building.id + " " + sentence_about(*run), "map");
  }
  return html + element("div", figures, "side") + "\n";
}

std::string buildings_html(const BuildingsExperiment& experiment) {
  std::string figures;
  const std::string contender = experiment.groups.empty() ? "" : experiment.groups.front().contender;
  for (const BuildingRuns& building : experiment.buildings)
    figures += figure(
        ways_picture(building, contender),
        fmt::format("{}: {:.0f} m², symmetry {:.2f}, clutter {:.2f}", building.building.id,
                    building.building.request.size_m2, building.building.request.symmetry, building.building.clutter),
        "map");
  return text_element("h2", "The buildings") + key_html() + element("div", figures, "side small") + "\n";
}

}  // namespace

std::string buildings_page(const BuildingsExperiment& experiment) {
  std::string symbols;
  for (const BuildingRuns& building : experiment.buildings) symbols += outline_symbol(building);
  return html_page("Many buildings",
                   "<svg class=\"building\" width=\"0\" height=\"0\" style=\"position:absolute\"><defs>" + symbols +
                       "</defs></svg>\n" +
                       text_element("p", experiment.command + "; intervals are 95 %, over buildings") +
                       groups_html(experiment) + failures_html(experiment) + buildings_html(experiment));
}

std::vector<std::pair<std::string, IntervalPlot>> share_plots(const BuildingsExperiment& experiment) {
  std::vector<std::pair<std::string, IntervalPlot>> plots;
  for (const std::string& contender : contenders_of(experiment)) {
    plots.emplace_back(contender + "_success", success_plot(experiment, contender));
    plots.emplace_back(contender + "_wrong", wrong_plot(experiment, contender));
  }
  return plots;
}

}  // namespace opal::experiments
