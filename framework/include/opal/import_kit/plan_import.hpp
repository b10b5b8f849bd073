#pragma once

#include <opal/import_kit/class_rules.hpp>
#include <opal/import_kit/plan_assembly.hpp>
#include <opal/map/map_importer.hpp>

#include <set>
#include <string>
#include <vector>

namespace opal {

/// Options that all importers of plans have, as their plugin.jsonld describes them: `classes`, `perceivable`, `sensor`,
/// `max_wall_thickness_m`, `min_face_m`.
struct PlanImportOptions {
  /// @param options   of the importer, complete and checked.
  /// @param defaults  for ClassRules.
  PlanImportOptions(const nlohmann::json& options, const std::map<std::string, std::string>& defaults);

  /// What perceives objects of a type; empty: nothing does.
  std::string sensor_for(const std::string& type) const;

  ClassRules rules;                   ///< from layers or classes to object types
  std::set<std::string> perceivable;  ///< types of objects that the sensor sees where the plan is cut
  std::string sensor;                 ///< id of the sensor that perceives these types
  PlanOptions plan;                   ///< wall thickness and least face, as the options say
};

/// Puts what became of the plan's elements into the report: outline, status and reason of the things with the same ids.
void report_outcomes(const std::vector<PlanElement>& plan, const PlanAssembly& assembly,
                     std::vector<ImportedElement>& things);

/// In order of id, numbers inside ids counting as numbers, as importers hand them over.
void sort_by_id(std::vector<ImportedElement>& elements);

/// A sentence about the extent of a map, with a doubt if no building is so small or large.
std::string extent_sentence(const SemanticMap& map);

}  // namespace opal
