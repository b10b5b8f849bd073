#include <opal/import_kit/plan_import.hpp>

#include "map/check/map_check.hpp"
#include "map/semantic_map_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <unordered_map>

namespace opal {
namespace {

constexpr double kSmallestBuilding_m = 2, kLargestBuilding_m = 2000;

std::set<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::set<std::string> words;
  for (std::string word; stream >> word;) words.insert(word.find(':') == std::string::npos ? "opal:" + word : word);
  return words;
}

void add_outline(const PlanElement& element, ImportedElement& thing) {
  thing.circles = element.circles;
  for (const PlanLine& line : element.lines)
    for (std::size_t k = 0; k + 1 < line.points.size() + (line.closed ? 1 : 0); ++k)
      thing.outline.push_back({line.points[k], line.points[(k + 1) % line.points.size()]});
}

void explain(const PlanOutcome& outcome, ImportedElement& element) {
  switch (outcome.status) {
    case PlanOutcome::Status::mapped: element.status = ImportStatus::imported; break;
    case PlanOutcome::Status::merged:
      element.status = ImportStatus::merged;
      element.reason = "its lines run where those of " + outcome.with + " do";
      break;
    case PlanOutcome::Status::hidden:
      element.status = ImportStatus::left_out;
      element.reason = "it lies inside of walls or columns, where nothing sees it";
      break;
    case PlanOutcome::Status::empty:
      element.status = ImportStatus::left_out;
      element.reason = "it has no line that is long enough for a face";
      break;
  }
}

}  // namespace

PlanImportOptions::PlanImportOptions(const nlohmann::json& options, const std::map<std::string, std::string>& defaults)
    : rules(options.at("classes"), defaults),
      perceivable(words_of(options.at("perceivable"))),
      sensor(options.at("sensor")) {
  plan.max_wall_thickness_m = options.at("max_wall_thickness_m");
  plan.min_face_m = options.at("min_face_m");
}

std::string PlanImportOptions::sensor_for(const std::string& type) const {
  return perceivable.contains(type) ? sensor : "";
}

void report_outcomes(const std::vector<PlanElement>& plan, const PlanAssembly& assembly,
                     std::vector<ImportedElement>& things) {
  std::unordered_map<std::string, std::size_t> numbers;
  for (std::size_t k = 0; k < plan.size(); ++k) numbers[plan[k].id] = k;
  for (ImportedElement& thing : things) {
    const auto found = numbers.find(thing.id);
    if (found == numbers.end() || thing.status != ImportStatus::imported) continue;
    add_outline(plan[found->second], thing);
    explain(assembly.outcomes[found->second], thing);
  }
}

void sort_by_id(std::vector<ImportedElement>& elements) {
  std::stable_sort(elements.begin(), elements.end(),
                   [](const ImportedElement& a, const ImportedElement& b) { return id_before(a.id, b.id); });
}

std::string extent_sentence(const SemanticMap& map) {
  const MapCheck check = check_map(map);
  const Point size = check.bounds[1] - check.bounds[0];
  const bool is_doubtful = size.maxCoeff() < kSmallestBuilding_m || size.maxCoeff() > kLargestBuilding_m;
  return fmt::format("extent {:.2f} m x {:.2f} m{}", size.x(), size.y(),
                     is_doubtful ? ": doubtful for a building, is the unit right?" : "");
}

}  // namespace opal
