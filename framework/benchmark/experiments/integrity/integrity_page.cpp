#include "benchmark/experiments/integrity/integrity_page.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/experiments/kit/ways_picture.hpp"
#include "benchmark/runs/event_file.hpp"
#include "benchmark/runs/view_page.hpp"
#include "common/text_file.hpp"
#include "common/whole_file.hpp"
#include "localization/events/run_events.hpp"
#include "report/html_elements.hpp"
#include "report/plot.hpp"
#include "sensing/trajectory.hpp"

#include <fmt/format.h>

#include <optional>

namespace opal::experiments {
namespace {

/// Way and wrong poses of one drive.
class Trace {
 public:
  void add(const JudgedAnswer& answer) {
    constexpr double kEvery_m = 0.2;
    const bool is_elsewhere = !before_ || simulation::was_kidnapped(*before_, answer.truth);
    before_ = answer.truth;
    auto& stretches = way_.stretches;
    const Point at = answer.truth.position();
    if (is_elsewhere)
      stretches.push_back({{at}, true});
    else if ((stretches.back().points.back() - at).norm() > kEvery_m)
      stretches.back().points.push_back(at);
    if (answer.is_localized && !answer.is_right) way_.estimate.push_back(answer.said.position());
    if (answer.is_right && way_.marks.empty()) way_.marks.push_back(at);
  }
  std::string picture(const SemanticMap& map, const std::string& name) const {
    WaysPicture::Way way = way_;
    way.name = name;
    return svg_of(map, {way.stretches.empty() ? std::vector<WaysPicture::Way>{} : std::vector{way}, {}, {}});
  }

 private:
  WaysPicture::Way way_;
  std::optional<Pose2> before_;  ///< the truth of the answer before
};

std::vector<StampedPose> truth_of(const simulation::Recording& recording) {
  std::vector<StampedPose> truth;
  for (const simulation::RecordedScan& each : recording.scans) truth.push_back({each.scan.stamp_s, each.T_map_base});
  return truth;
}

std::string caption_of(const JudgedDrive& judged) {
  const auto& [drive, run, cpu_s, failure] = judged;
  std::string text = fmt::format("Drive {}: {}, {} map, {} laser{}, event: {}. ", drive.number, drive.building_id,
                                 name_of(drive.map_state), drive.has_two_lasers ? "two" : "one",
                                 drive.has_two_lasers ? "s" : "", event_of(drive));
  if (!failure.empty()) return text + "It " + failure + ".";
  return text + fmt::format("A wrong pose was called localized for {} s at a time, {} s in all, first after {} s.",
                            number(run.localized.longest_wrong_s, 1), number(run.localized.wrong_s, 1),
                            number(run.localized.wrong_from_s.value_or(kNever), 1));
}

/// Bounds of all strata beside their table.
std::string strata_html(const std::vector<Stratum>& strata) {
  IntervalPlot plot;
  plot.axis = {"false drives of 1,000"};
  plot.table = strata_table(strata);
  for (const Stratum& stratum : strata) {
    const statistics::Interval share = stratum.false_share();
    const double whole = static_cast<double>(std::max<std::size_t>(stratum.drives.size(), 1));
    plot.rows.push_back({1000 * static_cast<double>(stratum.false_drives()) / whole, 1000 * share.low,
                         1000 * share.high, "open", stratum.aspect == "all"});
  }
  return plot_html(plot, "share of false drives by stratum, with 95 % intervals");
}

std::string worst_html(const std::vector<ShownDrive>& worst) {
  std::string html;
  for (const ShownDrive& shown : worst)
    html += element("div", figure(shown.picture, caption_of(shown.drive), "map") +
                               (shown.page.empty() ? "" : linked(shown.page, text_element("p", "Look at this drive"))) +
                               details("its document, from which it is repeated",
                                       text_element("pre", to_json(shown.drive.drive).dump(1))));
  return element("div", html, "side");
}

}  // namespace

ShownDrive repeat_drive(const DrawnDrive& drive, const CampaignRobots& robots, const std::filesystem::path& folder) {
  make_folder(folder.string());
  write_text((folder / "drive.json").string(), to_json(drive).dump(1) + '\n');
  const DriveWorld world = world_of(drive, robots, folder);
  const std::string name = fmt::format("drive {}", drive.number);
  benchmark::EventFile events((folder / "events.jsonl").string());
  events.write(run_event({name, "", ""}, robots.of(drive).lasers.front()));
  events.write(map_event(MapView(world.map, robots.of(drive).lasers.front().id)));
  events.write(start_event(name));
  Trace trace;
  ShownDrive shown{{drive, {}, 0, ""}, "", ""};
  IntegrityObserver observer;
  observer.events = &events;
  observer.begins = [&](const simulation::Recording& recording) { events.write(truth_event(truth_of(recording))); };
  observer.answered = [&](const JudgedAnswer& answer) { trace.add(answer); };
  shown.drive.run = run_drive(drive, world, robots, observer);
  events.finish();
  benchmark::write_view_page({{folder.string(), name}}, (folder / "page.html").string());
  shown.picture = trace.picture(*world.map, name);
  return shown;
}

std::string integrity_page(const std::string& command, const std::vector<Stratum>& strata,
                           const std::vector<ShownDrive>& worst) {
  std::string body =
      text_element("p", bound_sentence(strata.front())) +
      text_element("p",
                   "Right means: within 1 m and 10 degrees. A drive is false if it called a wrong pose localized for "
                   "longer than 1 s, crashed or hung. Drives through one building are no independent trials: intervals "
                   "are those of Clopper and Pearson for as many independent drives as tell as much (Korn and "
                   "Graubard 1998).") +
      text_element("code", command) + strata_html(strata) +
      text_element("h2", fmt::format("The worst drives: {}", worst.size()));
  if (!worst.empty())
    body += text_element("p",
                         "The robot's map, its way in truth from the ring on, a cross where a right pose was called "
                         "localized first; thin: wrong poses that were called localized.") +
            worst_html(worst);
  return html_page("Integrity campaign", body);
}

}  // namespace opal::experiments
