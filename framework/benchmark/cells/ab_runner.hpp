#pragma once

#include "benchmark/cells/ab_observation.hpp"
#include "benchmark/cells/ab_world.hpp"

#include "benchmark/ab/execution/cell_runner.hpp"

namespace opal::benchmark {

/// The plugins that an arm may use: the program's own, and the arm's.
struct ArmPlugins {
  std::shared_ptr<const opal::PluginRegistry> registry;
  nlohmann::ordered_json files;  ///< name, version and digest of each
};

/// By arm. Arms without folders of their own share one registry.
/// @throws opal::ConfigError if a plugin is refused, or a part of an arm's deployment is not there.
std::vector<ArmPlugins> load_arm_plugins(const opal::ab::Experiment& experiment);

/// Computes cells with the pipeline of this program.
class LocalizingRunner final : public opal::ab::CellRunner {
 public:
  LocalizingRunner(const opal::ab::Experiment& experiment, const std::vector<ArmPlugins>& plugins, WorldSource& worlds)
      : experiment_(experiment), plugins_(plugins), worlds_(worlds) {}

  void enter(const opal::ab::Task& task) override;
  std::string input(const opal::ab::Task& task) const override;
  void set_up(std::size_t arm) override;
  void run(const opal::ab::Task& task, opal::ab::CellResult& result) override;

  /// Runs a cell of the world that is entered once more, for its event stream. May throw, crash or hang.
  void record(const opal::ab::Task& task, std::size_t arm, const std::string& folder) const;

 private:
  opal::LocalizerParts parts_of(opal::Deployment deployment, std::size_t arm) const;

  const opal::ab::Experiment& experiment_;
  const std::vector<ArmPlugins>& plugins_;
  WorldSource& worlds_;
  opal::ab::Task entered_;
  std::optional<World> world_;
  std::unique_ptr<opal::Localizer> localizer_;
  std::vector<ObservedScorer> observed_;
};

}  // namespace opal::benchmark
