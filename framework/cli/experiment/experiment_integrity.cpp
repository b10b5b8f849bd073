#include "cli/experiment/experiment_integrity.hpp"

#include "benchmark/runs/progress_bar.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/number_option.hpp"
#include "cli/terminal/run_end.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "output/output_folder.hpp"
#include "session/session.hpp"
#include "session/shipped_files.hpp"

#include "benchmark/ab/records/program_files.hpp"
#include "benchmark/experiments/integrity/integrity_page.hpp"
#include "common/text_file.hpp"
#include "report/table_files.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <thread>

namespace opal::cli {
namespace {

namespace ab = ab;
namespace experiments = experiments;
namespace fs = std::filesystem;

struct IntegrityVerbOptions {
  experiments::CampaignRequest campaign;
  std::string one_laser = "default", two_lasers = "two_lasers", out, shard = "1/1", repeat;
  std::size_t worst = 12;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

/// A deployment with lasers to simulate: its own, or the simulator's.
Deployment robot_of(const std::string& config) {
  const Deployment deployment = read_deployment(session::config_file(config));
  if (deployment.describes_laser && !takes_geometry_from_log(deployment)) return deployment;
  return with_lasers(deployment, {simulation::SimulationOptions::default_laser()});
}

nlohmann::ordered_json manifest_of(const IntegrityVerbOptions& options, const experiments::CampaignRobots& robots) {
  const auto text_of = [](const Deployment& robot) { return read_json(robot.file); };
  nlohmann::ordered_json campaign = to_json(options.campaign);
  campaign.erase("drives");  // no drive depends on how many there are: a campaign may grow
  return {{"opal", ab::program_files()},
          {"plugins", ab::plugin_files(*robots.registry)},
          {"campaign", std::move(campaign)},
          {"one_laser", text_of(robots.one_laser)},
          {"two_lasers", text_of(robots.two_lasers)}};
}

std::string command_of(const IntegrityVerbOptions& options) {
  const experiments::CampaignRequest& campaign = options.campaign;
  return fmt::format(
      "opal experiment integrity -o out --drives {} --buildings {} --seed {} --duration {} --one-laser {} --two-lasers "
      "{}",
      campaign.drives, campaign.buildings, campaign.seed, campaign.duration_s, options.one_laser, options.two_lasers);
}

std::vector<experiments::ShownDrive> shown_worst(const std::vector<experiments::JudgedDrive>& drives,
                                                 const experiments::CampaignRobots& robots,
                                                 const IntegrityVerbOptions& options) {
  std::vector<experiments::ShownDrive> shown;
  for (const experiments::JudgedDrive& drive : worst_drives(drives, options.worst)) {
    const std::string name = fmt::format("worst/{:05}", drive.drive.number);
    if (drive.failure.empty()) {
      shown.push_back(repeat_drive(drive.drive, robots, fs::path(options.out) / name));
      shown.back().page = name + "/page.html";
    } else {
      shown.push_back({drive, "", ""});
    }
  }
  return shown;
}

void write_report(const IntegrityVerbOptions& options, const experiments::Campaign& campaign,
                  const experiments::CampaignRobots& robots, const ab::ResultFolder& folder) {
  const std::vector<experiments::JudgedDrive> drives = judged_drives(campaign, folder);
  const std::vector<experiments::Stratum> strata = experiments::strata_of(drives);
  const Table table = strata_table(strata);
  std::cout << markdown_of(table) << bound_sentence(strata.front()) << '\n';
  write_table(folder.file("table"), table);
  write_text(folder.file("table.txt"), markdown_of(table));
  write_text(folder.file("drives.csv"), csv_of(drive_rows(drives)));
  write_text(folder.file("summary.json"), summary_json(options.campaign, strata).dump(1) + '\n');
  write_text(folder.file("report.html"),
             integrity_page(command_of(options), strata, shown_worst(drives, robots, options)));
  std::cout << "written: report.html, table.*, drives.csv, summary.json, worst in " << options.out << '\n';
}

int run_campaign(const IntegrityVerbOptions& options, const experiments::CampaignRobots& robots) {
  const StopSignals signals;  // before other threads
  const experiments::Campaign campaign(options.campaign);
  const ab::ResultFolder folder(options.out, manifest_of(options, robots));
  const ab::Shard shard = ab::read_shard(options.shard);
  {
    benchmark::ProgressBar bar;
    drive_campaign(
        campaign, robots, folder, shard, options.jobs,
        [&](std::size_t done, std::size_t all) {
          bar.show(all == 0 ? 1 : static_cast<double>(done) / static_cast<double>(all),
                   fmt::format("{} of {}", done, all));
        },
        signals.token());
  }
  if (signals.signal() != 0) {
    std::cerr << "opal: interrupted: " << options.out << " holds what was driven; the same command goes on\n";
    return interrupted_by(signals.signal());
  }
  if (shard.of == 1) write_report(options, campaign, robots, folder);
  return kDone;
}

/// A drive of the campaign by its number, or the drive of a document.
experiments::DrawnDrive drive_to_repeat(const IntegrityVerbOptions& options) {
  const std::string& asked = options.repeat;
  const bool is_number = std::ranges::all_of(asked, [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!is_number || fs::exists(asked)) return experiments::drawn_drive_from(read_json(asked), asked);
  const experiments::Campaign campaign(options.campaign);
  std::size_t number = campaign.size();
  std::from_chars(asked.data(), asked.data() + asked.size(), number);
  if (number >= campaign.size())
    throw ConfigError(
        fmt::format("--repeat {}: expected a drive of the campaign, 0 to {}", asked, campaign.size() - 1));
  return campaign.drive(number);
}

int repeat(const IntegrityVerbOptions& options, const experiments::CampaignRobots& robots) {
  const experiments::DrawnDrive drive = drive_to_repeat(options);
  OutputFolder folder(options.out, "opal experiment integrity --repeat",
                      {"drive.json", "events.jsonl", "page.html", "run.json", "picture.svg"});
  const experiments::ShownDrive shown = repeat_drive(drive, robots, folder.path());
  const nlohmann::ordered_json values = values_of(shown.drive.run);
  write_text(folder.file("run.json"), values.dump(1) + '\n');
  write_text(folder.file("picture.svg"), shown.picture);
  std::cout << values.dump(1) << "\nwritten: run.json, drive.json, events.jsonl, page.html, picture.svg in "
            << options.out << '\n';
  return end_run(folder, 0, kDone);
}

int integrity(const IntegrityVerbOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const experiments::CampaignRobots robots{robot_of(options.one_laser), robot_of(options.two_lasers), &registry};
  check_parts(robots.one_laser, registry);
  check_parts(robots.two_lasers, registry);
  return options.repeat.empty() ? run_campaign(options, robots) : repeat(options, robots);
}

}  // namespace

void add_experiment_integrity(CLI::App& experiment, int& exit_code) {
  auto o = std::make_shared<IntegrityVerbOptions>();
  CLI::App* verb = experiment.add_subcommand(
      "integrity", "thousands of drives drawn by a seed: how often a wrong pose is called localized, as a bound");
  verb->add_option("-o,--out", o->out,
                   "folder for results and report; what is driven there already is not driven again")
      ->required();
  add_number(*verb, "--drives", o->campaign.drives, std::size_t{1}, std::size_t{10'000'000}, "of the campaign");
  add_number(*verb, "--buildings", o->campaign.buildings, 1, 1'000'000, "through which they go by turns");
  add_number(*verb, "--duration", o->campaign.duration_s, 10.0, 3600.0, "of each drive [s]");
  verb->add_option("--seed", o->campaign.seed, "of the campaign")->capture_default_str();
  verb->add_option("--one-laser", o->one_laser, "deployment of the robot with one laser: a file, or a shipped name")
      ->capture_default_str();
  verb->add_option("--two-lasers", o->two_lasers, "the same with two lasers")->capture_default_str();
  verb->add_option("--shard", o->shard,
                   "only this part, as a job array's task: 3/50; the report is made without --shard")
      ->capture_default_str();
  add_number(*verb, "--worst", o->worst, std::size_t{0}, std::size_t{1000}, "drives that get a page");
  verb->add_option("--repeat", o->repeat,
                   "only repeat the drive of this document (drive.json), or of this number, and leave its page");
  add_number(*verb, "--jobs", o->jobs, 1, 1000, "at the same time; results do not depend on it");
  verb->callback([o, &exit_code] { exit_code = integrity(*o); });
}

}  // namespace opal::cli
