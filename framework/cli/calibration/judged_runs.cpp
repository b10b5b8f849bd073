#include "cli/calibration/judged_runs.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>
#include "evaluation/ground_truth.hpp"
#include "evaluation/results.hpp"

#include <filesystem>
#include <map>
#include <set>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

/// Where the truth of a run is.
fs::path truth_of(const fs::path& run, const std::string& folder) {
  const fs::path summary = run / "summary.json";
  if (!fs::exists(summary))
    throw LogError(summary.string() + ": does not exist, expected a folder that opal bench wrote");
  const nlohmann::json document = read_json(summary.string());
  if (!document.contains("site") || !document["site"].is_string())
    throw LogError(summary.string() +
                   ": /site: missing, expected a folder that opal bench wrote; other commands write other summaries");
  const fs::path prefix(document["site"].get<std::string>());
  fs::path truth = folder.empty() ? prefix : fs::path(folder) / prefix.filename();
  truth += ".gt.csv";
  if (!fs::exists(truth))
    throw LogError(truth.string() + ": does not exist, expected the recorded truth of " + run.string() +
                   "; name its folder with --truth");
  return truth;
}

using QueryMoment = std::pair<std::string, double>;  // query and stamp
std::map<QueryMoment, std::vector<AlternativeRow>> alternatives_by_moment(const fs::path& run) {
  std::map<QueryMoment, std::vector<AlternativeRow>> alternatives;
  for (AlternativeRow& row : read_alternatives((run / "alternatives.csv").string())) {
    QueryMoment moment{row.query, row.stamp_s};
    alternatives[std::move(moment)].push_back(std::move(row));
  }
  return alternatives;
}

}  // namespace

void JudgedRuns::add(const std::string& run, const std::string& folder, const PoseTolerance& tolerance) {
  const GroundTruth truth = GroundTruth::read(truth_of(run, folder).string());
  const auto alternatives = alternatives_by_moment(run);
  const std::string number = std::to_string(++runs);  // the same query in another run is another one
  std::set<std::string> seen, flagged, falsely;
  const std::size_t rows_before = rows;
  for (const ResultRow& row : read_results((fs::path(run) / "results.csv").string())) {
    const auto pose = truth.T_map_laser_at(row.stamp_s);
    if (!pose) continue;
    const std::string query = number + "/" + row.query;
    const bool right = tolerance.holds(row.T_map_laser, *pose);
    bool any_right = right;
    seen.insert(query);
    ++rows;
    best.push_back({query, row.probability, right});
    places.push_back(best.back());
    if (const auto found = alternatives.find({row.query, row.stamp_s}); found != alternatives.end())
      for (const AlternativeRow& alternative : found->second) {
        const bool alternative_right = tolerance.holds(alternative.T_map_laser, *pose);
        any_right = any_right || alternative_right;
        places.push_back({query, alternative.probability, alternative_right});
      }
    none.push_back({query, row.none, !any_right});
    if (!row.localized()) continue;
    ++flagged_rows;
    false_rows += !right;
    flagged.insert(query);
    if (!right) falsely.insert(query);
  }
  if (rows == rows_before)
    throw LogError(run + "/results.csv: no row at a time of the recorded truth, expected at least one");
  queries += seen.size();
  flagged_queries += flagged.size();
  false_queries += falsely.size();
}

}  // namespace opal::cli
