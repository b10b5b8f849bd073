#include "benchmark/experiments/goals/goal_report.hpp"
#include "benchmark/experiments/kit/by_name.hpp"
#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/experiments/kit/published.hpp"
#include "benchmark/experiments/kit/time_plot.hpp"
#include "benchmark/experiments/kit/ways_picture.hpp"
#include "report/html_elements.hpp"

#include <fmt/format.h>

namespace opal::experiments {
namespace {

using Run = GoalRun;

/// Dotted while it searched or inspected, solid under way to the goal.
std::vector<WaysPicture::Stretch> stretches_of(const Run& run) {
  std::vector<WaysPicture::Stretch> all;
  for (const JudgedMoment& moment : run.moments) {
    const Point here = moment.truth.position();
    if (all.empty() || all.back().solid != moment.under_way) {
      const bool goes_on = !all.empty() && !all.back().points.empty();
      const Point from = goes_on ? all.back().points.back() : here;
      all.push_back({{from}, moment.under_way});
    }
    if ((all.back().points.back() - here).norm() > 0.05) all.back().points.push_back(here);
  }
  return all;
}

WaysPicture::Way way_of(const Run& run) {
  WaysPicture::Way way{run.task, stretches_of(run), {}, {}, {}};
  for (const Run::Start& start : run.starts) way.stars.push_back({start.from, start.features});
  return way;
}

std::string ways_of(const SemanticMap& map, const std::vector<const Run*>& runs) {
  WaysPicture picture;
  for (const Run* run : runs) picture.ways.push_back(way_of(*run));
  if (!runs.empty()) picture.goals.push_back(runs.front()->goal);
  return svg_of(map, picture);
}

/// One run close up: the estimate over the truth, a cross where it localized.
std::string one_way(const SemanticMap& map, const Run& run) {
  WaysPicture::Way way = way_of(run);
  for (const JudgedMoment& moment : run.moments) {
    if (!moment.localized()) continue;
    if (way.marks.empty()) way.marks.push_back(moment.truth.position());
    way.estimate.push_back(moment.estimate.position());
  }
  return svg_of(map, {{way}, {run.goal}, {}});
}

std::string caption_of(const Run& run) {
  return fmt::format("{}, seed {}: {} after {}, {} m; {}{}", run.task, run.seed, drive_ending(run.reached, run.said_so),
                     minutes(run.time_s), number(run.driven_m, 1),
                     run.localized_after_m == kNever ? "never localized"
                                                     : "localized after " + number(run.localized_after_m, 1) + " m",
                     run.collisions > 0 ? "; touched something in " + std::to_string(run.collisions) + " steps" : "");
}

std::string close_up(const SemanticMap& map, const std::vector<const Run*>& runs) {
  std::string figures;
  for (const Run* run : runs) figures += figure(one_way(map, *run) + time_plot(run->moments), caption_of(*run), "map");
  return element("div", figures, "side");
}

constexpr const char* kAbout =
    "The 12 runs of Hendrikx (2023), table 4.1, driven in simulation in the building {}: from six places that the "
    "robot "
    "is not told to one goal; A with binary patterns of columns, B with triples (a configuration that names no "
    "patterns "
    "uses its own in both). Medians over the seeds, a drive that does not arrive takes for ever; means for starts and "
    "recoveries. The published times are of another robot in another building: a yardstick, no more.";

}  // namespace

std::string goal_page(const SemanticMap& map, std::span<const Run> runs) {
  std::string body = text_element("p", fmt::format(kAbout, map.name())) + html_of(goal_table(runs));
  const std::uint64_t first = runs.empty() ? 0 : runs.front().seed;
  for (const std::string& contender : names(runs, &Run::contender)) {
    const auto shown = those(runs, [&](const Run& r) { return r.contender == contender && r.seed == first; });
    const auto failed = those(runs, [&](const Run& r) {
      return r.contender == contender && r.seed != first && (!r.reached || r.collisions > 0);
    });
    body += text_element("h2", contender);
    for (const char* set : {"A", "B"}) {
      std::vector<const Run*> of_set = shown;
      std::erase_if(of_set, [&](const Run* run) { return !run->task.starts_with(set); });
      body += figure(ways_of(map, of_set),
                     fmt::format("Set {}, seed {}. Dotted: searching and inspecting; solid: on the way to the goal "
                                 "(blue). A dot joined with what was seen: hypotheses came up out of nothing.",
                                 set, first),
                     "map whole");
    }
    body += status_key() + close_up(map, shown);
    if (!failed.empty())
      body += text_element("h3", "Of the other seeds: not reached, or touched something") + close_up(map, failed);
  }
  return html_page("Closed loop: the runs of table 4.1", body);
}

}  // namespace opal::experiments
