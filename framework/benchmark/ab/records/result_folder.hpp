#pragma once

#include "benchmark/ab/documents/cell_plan.hpp"
#include "benchmark/ab/records/journal.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <vector>

namespace opal::ab {

/// Where an experiment's results are: `manifest.json` says what is computed with what, `journals/` hold finished cells
/// as workers wrote them, `results.jsonl` and `times.jsonl` all of them in the order of their numbers.
class ResultFolder {
 public:
  /// Makes the folder, or goes on in it.
  /// @param manifest  everything that a result depends on.
  /// @throws ConfigError naming what is different if the folder's results were computed with something else.
  ResultFolder(const std::string& path, const nlohmann::ordered_json& manifest);

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return (std::filesystem::path(path_) / name).string(); }
  std::vector<std::string> journals() const;  ///< by name
  std::string journal(const Shard& shard, std::size_t worker) const;
  std::string log(const Shard& shard, std::size_t worker) const;  ///< what its arms and plugins print

 private:
  std::string path_;
};

/// Which cells are finished, by number.
std::vector<bool> finished_cells(const ResultFolder& folder, const CellPlan& plan);

}  // namespace opal::ab
