#include "benchmark/experiments/integrity/integrity_report.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/statistics/share_bound.hpp"

#include <opal/common/quantile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace opal::experiments {
namespace {

constexpr double kLevel = 0.05;  // both ends of an interval together miss the truth so often

bool is_false(const JudgedDrive& drive) { return !drive.failure.empty() || drive.run.is_false(); }

struct Aspect {
  const char* name;
  std::function<std::string(const DrawnDrive&)> value_of;
};

const std::vector<Aspect>& aspects() {
  using Drive = const DrawnDrive&;
  static const std::vector<Aspect> all{
      {"building", [](Drive drive) { return drive.building.kind; }},
      {"alike", [](Drive drive) { return fmt::format("symmetry {:.2f}", drive.building.symmetry); }},
      {"storeys", [](Drive drive) { return drive.storeys == 1 ? std::string("one") : "three, unknown which"; }},
      {"map", [](Drive drive) { return std::string(name_of(drive.map_state)); }},
      {"lasers", [](Drive drive) { return drive.has_two_lasers ? std::string("two") : "one"; }},
      {"furniture", [](Drive drive) { return drive.along_walls > 0 ? std::string("along walls") : "everyday"; }},
      {"event", [](Drive drive) { return event_of(drive); }}};
  return all;
}

/// Of those that have the value; `share` 0.5: the median. Those without count as never.
double quantile_over(const std::vector<const JudgedDrive*>& drives, std::optional<double> IntegrityRun::*value,
                     double share) {
  std::vector<double> values;
  for (const JudgedDrive* drive : drives)
    if (drive->failure.empty()) values.push_back((drive->run.*value).value_or(kNever));
  std::ranges::sort(values);
  return opal::quantile_of(values, share).value_or(kNever);
}

template <class Test>
std::size_t count_if(const Stratum& stratum, Test test) {
  return static_cast<std::size_t>(std::ranges::count_if(stratum.drives, test));
}

std::size_t localized_drives(const Stratum& stratum) {
  return count_if(stratum, [](const JudgedDrive* drive) { return drive->run.localized_after_m.has_value(); });
}

std::string per_thousand(double share) { return fmt::format("{:.1f}", 1000 * share); }

std::string value_text(const std::optional<double>& value) { return value ? fmt::format("{:.2f}", *value) : ""; }

nlohmann::json quantile_json(const Stratum& stratum, double share) {
  const double after_m = quantile_over(stratum.drives, &IntegrityRun::localized_after_m, share);
  return std::isfinite(after_m) ? nlohmann::json(after_m) : nlohmann::json();
}

/// How bad a drive was, for sorting.
double badness(const JudgedDrive& drive) {
  return drive.failure.empty() ? drive.run.localized.longest_wrong_s : kNever;
}

}  // namespace

std::size_t Stratum::false_drives() const {
  return count_if(*this, [](const JudgedDrive* drive) { return is_false(*drive); });
}

statistics::Interval Stratum::false_share() const {
  std::map<std::string, statistics::ClusterCount> buildings;
  for (const JudgedDrive* drive : drives) {
    statistics::ClusterCount& building = buildings[drive->drive.building_id];
    building.part += is_false(*drive) ? 1 : 0;
    ++building.whole;
  }
  std::vector<statistics::ClusterCount> clusters;
  for (const auto& [id, count] : buildings) clusters.push_back(count);
  return statistics::share_interval(clusters, kLevel);
}

std::vector<Stratum> strata_of(std::span<const JudgedDrive> drives) {
  std::vector<Stratum> strata{{"all", "", {}}};
  for (const JudgedDrive& drive : drives) strata.front().drives.push_back(&drive);
  for (const Aspect& aspect : aspects()) {
    std::map<std::string, std::vector<const JudgedDrive*>> by_value;
    for (const JudgedDrive& drive : drives) by_value[aspect.value_of(drive.drive)].push_back(&drive);
    for (auto& [value, these] : by_value) strata.push_back({aspect.name, value, std::move(these)});
  }
  return strata;
}

std::string bound_sentence(const Stratum& all) {
  if (all.drives.empty()) return "No drive has ended yet.";
  const double median_m = quantile_over(all.drives, &IntegrityRun::localized_after_m, 0.5);
  return fmt::format(
      "At most {} of 1,000 drives call a wrong pose localized for longer than {} s (upper end of the 95 % interval; {} "
      "of "
      "{} drives did). {} % of the drives are sure of their pose at some time, half of all after {} m.",
      per_thousand(all.false_share().high), number(kFalseAfter_s, 0), all.false_drives(), all.drives.size(),
      number(100.0 * static_cast<double>(localized_drives(all)) / static_cast<double>(all.drives.size()), 1),
      number(median_m, 1));
}

Table strata_table(const std::vector<Stratum>& strata) {
  Table table;
  table.columns = {{"aspect", "", false}, {"value", "", false},   {"drives"},          {"false"}, {"of 1,000, at most"},
                   {"localized", "%"},    {"after, median", "m"}, {"95 % within", "m"}};
  for (const Stratum& stratum : strata) {
    const double whole = static_cast<double>(std::max<std::size_t>(stratum.drives.size(), 1));
    table.rows.push_back({stratum.aspect, stratum.value, std::to_string(stratum.drives.size()),
                          std::to_string(stratum.false_drives()), per_thousand(stratum.false_share().high),
                          number(100.0 * static_cast<double>(localized_drives(stratum)) / whole, 1),
                          number(quantile_over(stratum.drives, &IntegrityRun::localized_after_m, 0.5), 1),
                          number(quantile_over(stratum.drives, &IntegrityRun::localized_after_m, 0.95), 1)});
  }
  table.grouped = true;
  return table;
}

Table drive_rows(std::span<const JudgedDrive> drives) {
  Table table;
  table.columns = {{"drive"},
                   {"building", "", false},
                   {"storeys"},
                   {"map", "", false},
                   {"lasers"},
                   {"along_walls"},
                   {"people"},
                   {"event", "", false},
                   {"wrong_s"},
                   {"longest_wrong_s"},
                   {"wrong_from_s"},
                   {"localized_after_m"},
                   {"localized_s"},
                   {"recovered_after_s"},
                   {"right_at_end"},
                   {"driven_m"},
                   {"answers"},
                   {"cpu_s"},
                   {"failure", "", false}};
  for (const auto& [drive, run, cpu_s, failure] : drives)
    table.rows.push_back(
        {std::to_string(drive.number), drive.building_id, std::to_string(drive.storeys), name_of(drive.map_state),
         drive.has_two_lasers ? "2" : "1", fmt::format("{:.2f}", drive.along_walls), std::to_string(drive.people),
         event_of(drive), fmt::format("{:.2f}", run.localized.wrong_s),
         fmt::format("{:.2f}", run.localized.longest_wrong_s), value_text(run.localized.wrong_from_s),
         value_text(run.localized_after_m), fmt::format("{:.2f}", run.localized.right_s),
         value_text(run.recovered_after_s), run.is_right ? "1" : "0", fmt::format("{:.1f}", run.driven_m),
         std::to_string(run.answers), fmt::format("{:.2f}", cpu_s), failure});
  return table;
}

std::vector<JudgedDrive> worst_drives(std::span<const JudgedDrive> drives, std::size_t most) {
  std::vector<JudgedDrive> worst;
  for (const JudgedDrive& drive : drives)
    if (badness(drive) > 0) worst.push_back(drive);
  std::ranges::stable_sort(worst, [](const JudgedDrive& a, const JudgedDrive& b) { return badness(a) > badness(b); });
  if (worst.size() > most) worst.resize(most);
  return worst;
}

nlohmann::ordered_json summary_json(const CampaignRequest& request, const std::vector<Stratum>& strata) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Stratum& stratum : strata) {
    const statistics::Interval share = stratum.false_share();
    rows.push_back(
        {{"aspect", stratum.aspect},
         {"value", stratum.value},
         {"drives", stratum.drives.size()},
         {"false_drives", stratum.false_drives()},
         {"false_share_95", {share.low, share.high}},
         {"localized_drives", localized_drives(stratum)},
         {"localized_after_m", {{"median", quantile_json(stratum, 0.5)}, {"95 %", quantile_json(stratum, 0.95)}}}});
  }
  return {{"campaign", to_json(request)}, {"sentence", bound_sentence(strata.front())}, {"strata", std::move(rows)}};
}

}  // namespace opal::experiments
