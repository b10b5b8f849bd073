#include "benchmark/experiments/challenges/challenge_report.hpp"
#include "benchmark/experiments/kit/by_name.hpp"
#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/experiments/kit/time_plot.hpp"
#include "benchmark/experiments/kit/ways_picture.hpp"
#include "report/html_elements.hpp"

#include <fmt/format.h>

namespace opal::experiments {
namespace {

using Run = ChallengeRun;

std::vector<Point> thinned_truth(const Run& run) {
  std::vector<Point> way;
  for (const JudgedMoment& moment : run.moments)
    if (way.empty() || (way.back() - moment.truth.position()).norm() > 0.1) way.push_back(moment.truth.position());
  return way;
}

/// Where it first said that it is localized.
std::vector<Point> first_localized(const Run& run) {
  for (const JudgedMoment& moment : run.moments)
    if (moment.localized()) return {moment.truth.position()};
  return {};
}

void add_region(const Run& run, WaysPicture& picture) {
  if (run.region) picture.regions.push_back({run.region->center, run.region->radius_m});
}

std::string ways_of(const SemanticMap& map, const std::vector<const Run*>& runs) {
  WaysPicture picture;
  for (const Run* run : runs) {
    picture.ways.push_back({run->challenge, {{thinned_truth(*run), true}}, first_localized(*run), {}, {}});
    add_region(*run, picture);
  }
  return svg_of(map, picture);
}

/// One run close up: the estimate over the truth.
std::string one_way(const SemanticMap& map, const Run& run) {
  WaysPicture::Way way{run.challenge, {{thinned_truth(run), true}}, first_localized(run), {}, {}};
  for (const JudgedMoment& moment : run.moments)
    if (moment.localized()) way.estimate.push_back(moment.estimate.position());
  WaysPicture picture{{way}, {}, {}};
  add_region(run, picture);
  return svg_of(map, picture);
}

std::string caption_of(const Run& run) {
  return run.challenge + ": " +
         (run.success ? "successful after " + number(*run.right_after_m, 1) + " m" : "not successful") +
         (run.localized_after_m ? ", localized after " + number(*run.localized_after_m, 1) + " m"
                                : ", never localized");
}

}  // namespace

std::string challenge_page(const SemanticMap& map, std::span<const Run> runs) {
  std::string body =
      text_element(
          "p", fmt::format("The challenges of Hendrikx (2023), section 3.5.2, driven in simulation in the building {}. "
                           "Success, distances, errors and hypotheses as in its 3.5.5; medians over the seeds. A: a "
                           "region is known; B: nothing is, with people and everyday clutter; C: features hidden and "
                           "mimicked on purpose.",
                           map.name())) +
      html_of(challenge_table(runs));
  const std::uint64_t first = runs.empty() ? 0 : runs.front().seed;
  for (const std::string& contender : names(runs, &Run::contender)) {
    const auto shown = those(runs, [&](const Run& r) { return r.contender == contender && r.seed == first; });
    body +=
        text_element("h2", fmt::format("{}, seed {}", contender, first)) +
        figure(ways_of(map, shown),
               fmt::format("The ways as they were driven; a ring is a start, a red circle a region that is known, a "
                           "cross where {} first said that it is localized.",
                           contender),
               "map whole") +
        status_key();
    std::string figures;
    for (const Run* run : shown)
      figures += figure(one_way(map, *run) + time_plot(run->moments),
                        caption_of(*run) + "; red: estimate where it was called localized", "map");
    body += element("div", figures, "side");
  }
  return html_page("Global localization: the challenges of table 3.3", body);
}

}  // namespace opal::experiments
