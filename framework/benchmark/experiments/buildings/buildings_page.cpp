#include "benchmark/experiments/buildings/buildings_page.hpp"

#include "benchmark/experiments/buildings/building_picture.hpp"
#include "benchmark/experiments/kit/table.hpp"
#include "report/html_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace opal::experiments {
namespace {

constexpr std::array kOutcomes{Outcome::localized, Outcome::unsure, Outcome::unknown, Outcome::wrong};

/// Colours that can be told apart by everyone (Okabe and Ito 2008).
constexpr const char* kStyle = R"(
body{font:15px/1.5 sans-serif;margin:2rem;max-width:130rem}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}td,th{padding:.15rem .7rem;text-align:right;border-bottom:1px solid #ddd}
td{white-space:nowrap}td:first-child,th:first-child{text-align:left}
.many{display:grid;grid-template-columns:repeat(auto-fill,minmax(var(--w),1fr));gap:1rem}
figure{margin:0}figcaption{font-size:12px;overflow-wrap:anywhere}svg{width:100%;max-height:22rem}
path{fill:none;vector-effect:non-scaling-stroke;stroke-width:1}.wall{stroke:#444}.unseen{stroke:#bcd}
.way{stroke-width:1.5}
path.localized{stroke:#009e73}path.unsure{stroke:#0072b2}path.unknown{stroke:#e69f00}path.wrong{stroke:#d55e00;stroke-width:2.5}
.claim{fill:#d55e00}.start{fill:#009e73}.believed{fill:none;stroke:#000;stroke-width:20}
i{display:inline-block;width:1.1em;height:.8em;margin:0 .3em 0 1em}
i.localized{background:#009e73}i.unsure{background:#0072b2}i.unknown{background:#e69f00}i.wrong{background:#d55e00}
.bar{display:flex;height:.9rem;width:11rem}.bar i{margin:0;height:100%}code{font-size:11px}
)";

constexpr const char* kMeaning =
    "<p><i class=localized></i>localized: the best hypothesis is right (within 1 m and 10 degrees) up to the end, and "
    "was "
    "called localized"
    "<i class=unsure></i>unsure: right up to the end, never called localized"
    "<i class=unknown></i>unknown: not right at the end, and nothing wrong was called localized"
    "<i class=wrong></i>wrong: a wrong pose was called localized at some time</p>\n";

using Shares = std::array<std::size_t, kOutcomes.size()>;

Shares outcomes_in(const BuildingsExperiment& experiment, const BuildingGroup& group) {
  Shares counts{};
  for (const BuildingRuns& building : experiment.buildings) {
    if (!group.kind.empty() && group.kind != building.building.request.kind) continue;
    if (group.difficulty && *group.difficulty != building.building.difficulty) continue;
    for (const ChallengeRun& run : building.runs)
      counts[static_cast<std::size_t>(outcome_of(run))] += run.contender == group.contender;
  }
  return counts;
}

std::string bar_of(const Shares& counts) {
  std::string bar = "<div class=bar>";
  for (Outcome outcome : kOutcomes) {
    const std::string count = std::to_string(counts[static_cast<std::size_t>(outcome)]), name = name_of(outcome);
    if (count != "0")
      bar += "<i class=" + name + " style=\"flex:" + count + "\" title=\"" + name + ": " + count + "\"></i>";
  }
  return bar + "</div>";
}

std::string cell(const BuildingShare& share) {
  char text[96];
  std::snprintf(text, sizeof text, "<td>%.1f <small>(%.1f to %.1f)</small></td>", 100 * share.share,
                100 * share.within.low, 100 * share.within.high);
  return text;
}

std::string cell(const BuildingMedian& found) {
  return "<td>" + number(found.median, 1) + " <small>(" + number(found.within.low, 1) + " to " +
         number(found.within.high, 1) + ")</small></td>";
}

std::string groups_of(const BuildingsExperiment& experiment) {
  std::string html;
  const std::string* contender = nullptr;
  for (const BuildingGroup& group : experiment.groups) {
    if (!contender || *contender != group.contender)
      html += std::string(contender ? "</table>\n" : "") + "<h2>" + html_text(group.contender) +
              "</h2>\n<table><tr><th>buildings<th>outcomes<th>buildings<th>runs<th>success %<th>localized, "
              "right %<th>falsely localized %"
              "<th>honestly unknown %<th>m to localized<th>s to localized<th>CPU ms</tr>\n";
    contender = &group.contender;
    html += "<tr><td>" + group.name() + "</td><td>" + bar_of(outcomes_in(experiment, group)) + "</td><td>" +
            std::to_string(group.buildings) + "</td><td>" + std::to_string(group.runs) + "</td>" + cell(group.success) +
            cell(group.localized) + cell(group.wrong) + cell(group.unknown) + cell(group.localized_after_m) +
            cell(group.localized_after_s) + "<td>" + number(group.cpu_ms, 2) + "</td></tr>\n";
  }
  return html + (contender ? "</table>\n" : "");
}

std::string sentence_about(const ChallengeRun& run) {
  const Moment& last = run.moments.back();
  std::string text =
      run.challenge + " (seed " + std::to_string(run.seed) + ", " + run.contender + "): " + name_of(outcome_of(run));
  if (run.false_rows > 0)
    text += "; called localized wrongly: " + std::to_string(run.false_rows) + " of " +
            std::to_string(run.moments.size()) + " scans, first after " + number(wrong_after_s(run), 1) + " s";
  if (run.localized_after_m >= 0) text += "; localized after " + number(run.localized_after_m, 1) + " m";
  return text + "; at the end " + (last.has_pose ? number(last.error_m(), 1) + " m off" : "no pose") + ", " +
         std::to_string(last.hypotheses) + " hypotheses; the truth has probability " + number(run.truth_probability, 2);
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

std::string figure(const std::string& picture, const std::string& caption) {
  return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string failures_html(const BuildingsExperiment& experiment) {
  constexpr std::size_t kMost = 200;
  const std::vector<Failure> failures = failures_of(experiment);
  std::string html =
      "<h2>Runs that were not localized, or were so wrongly: " + std::to_string(failures.size()) + "</h2>\n" +
      (failures.size() > kMost ? "<p>The first " + std::to_string(kMost) + " of them.</p>\n" : std::string()) +
      "<p>The way in truth from the green dot on; orange-red dots: wrong poses that were called localized; black "
      "ring: what is "
      "believed at the end. <code>--record</code> keeps the recording for <code>opal bench</code>, "
      "<code>localize</code> and "
      "<code>view</code>.</p>\n<div class=many style=\"--w:24rem\">";
  for (std::size_t k = 0; k < std::min(kMost, failures.size()); ++k)
    html +=
        figure(run_picture(*failures[k].building, *failures[k].run),
               failures[k].building->building.id + " " + html_text(sentence_about(*failures[k].run)) + "<br><code>" +
                   html_text(command_for(experiment, *failures[k].building, *failures[k].run)) + "</code>");
  return html + "</div>\n";
}

std::string buildings_html(const BuildingsExperiment& experiment) {
  std::string html = "<h2>The buildings</h2>\n<div class=many style=\"--w:15rem\">";
  const std::string contender = experiment.groups.empty() ? "" : experiment.groups.front().contender;
  for (const BuildingRuns& building : experiment.buildings)
    html +=
        figure(ways_picture(building, contender),
               building.building.id + ": " + number(building.building.request.size_m2, 0) + " m², symmetry " +
                   number(building.building.request.symmetry, 2) + ", clutter " + number(building.building.clutter, 2));
  return html + "</div>\n";
}

}  // namespace

std::string buildings_page(const BuildingsExperiment& experiment) {
  std::string symbols;
  for (const BuildingRuns& building : experiment.buildings) symbols += outline_symbol(building);
  return std::string("<!doctype html><html lang=en><meta charset=utf-8><title>Many buildings</title><style>") + kStyle +
         "</style>\n<svg style=\"position:absolute;width:0;height:0\"><defs>" + symbols +
         "</defs></svg>\n<h1>Many buildings</h1>\n<p><code>" + html_text(experiment.command) +
         "</code>; intervals are 95 %, over buildings</p>\n" + kMeaning + groups_of(experiment) +
         failures_html(experiment) + buildings_html(experiment) + "</html>\n";
}

}  // namespace opal::experiments
