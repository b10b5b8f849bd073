#include "ifc_importer.hpp"

#include "ifc_model.hpp"
#include "report.hpp"
#include "trial.hpp"

#include <opal/common/error.hpp>
#include <opal/common/letter_case.hpp>
#include <opal/import_kit/shaft_extent.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace opal::ifc_importer {
namespace {

using Kind = Treatment::Kind;

// Real models of 60,000 instances are read in half a second.
constexpr unsigned kTrial_s = 8;
constexpr std::size_t kInstancesPerSecond = 20'000;

std::string name_of(const std::string& path, const std::string& storey) {
  const std::string name = std::filesystem::path(path).stem().string();
  return storey.empty() ? name : name + ", " + storey;
}

bool comes_in(const ElementCut& cut, const Duplicates& duplicates) {
  return cut.is_cut() && cut.treatment.kind != Kind::left_out && duplicates.kept.count(cut.element->id) == 0;
}

/// Read once in a child process, and once more if that survived.
Building building_of(const std::string& path, const Point& origin_m) {
  const StepText step = StepText::read(path);
  const unsigned seconds = kTrial_s + static_cast<unsigned>(step.instances().size() / kInstancesPerSecond);
  try_in_child([&] { (void)read_building(step, path, origin_m); }, path, seconds);
  return read_building(step, path, origin_m);
}

/// Where two share a face, walls have it before columns, and these before the rest; frames come last.
int rank_of(const ElementCut& cut) {
  if (cut.treatment.kind == Kind::filling) return 3;
  if (cut.treatment.type == "opal:Wall") return 0;
  return cut.treatment.type == "opal:Column" ? 1 : 2;
}

std::vector<std::size_t> solids_in_order(const std::vector<ElementCut>& cuts) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < cuts.size(); ++k)
    if (!cuts[k].solid.empty()) order.push_back(k);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return rank_of(cuts[a]) < rank_of(cuts[b]); });
  return order;
}

/// "opal:Lift", "opal:Stair"; empty: it is neither.
std::string connection_type(const Element& element) {
  if (element.is_a("IfcTransportElement")) return "opal:Lift";
  return element.is_a("IfcStair") || element.is_a("IfcStairFlight") ? "opal:Stair" : "";
}

std::vector<MapConnection> connections_of(const std::vector<ElementCut>& cuts) {
  std::vector<MapConnection> connections;
  std::set<std::string> met;  // models have ids twice
  for (const ElementCut& cut : cuts) {
    if (!cut.is_cut() || !met.insert(cut.element->id).second) continue;
    const std::string type = connection_type(*cut.element);
    std::vector<Point> outline;
    for (const Segment& edge : segments_of(cut.outline)) outline.push_back(edge.begin);
    const auto extent = type.empty() ? std::nullopt : shaft_extent(outline);
    if (!extent) continue;
    connections.push_back(
        {cut.element->id + "/connection", type, cut.element->name, extent->radius_m, {{"", Pose2(extent->middle, 0)}}});
  }
  return connections;
}

MapOrigin origin_of(const Building& building, const LevelChoice& level, const std::vector<ElementCut>& chosen,
                    const std::vector<ElementCut>& cuts) {
  MapOrigin origin;
  origin.cut_height_m = level.height_m;
  origin.storey = level.storey;
  origin.widest_door_m = widest_door_m(chosen);
  origin.north_rad = building.north_rad;
  origin.georeference = building.georeference;
  origin.connections = connections_of(cuts);
  return origin;
}

}  // namespace

IfcImporter::IfcImporter(ImportOptions options) : options_(std::move(options)) { (void)Classes(options_.classes); }

bool IfcImporter::recognizes(const std::string& path) const {
  const std::string ending = lower_case_letters(std::filesystem::path(path).extension().string());
  return ending == ".ifc" && begins_like_step(path);
}

MapImport IfcImporter::import(const std::string& path) const {
  const Building building = building_of(path, options_.origin_m);
  const Classes classes(options_.classes);
  const LevelChoice level = choose_level(building, classes, options_, path);
  const std::vector<ElementCut> cuts = cut_storey(building, classes, level.height_m);
  const Duplicates duplicates = find_duplicates(cuts);
  std::vector<ElementCut> chosen;
  std::ranges::copy_if(cuts, std::back_inserter(chosen),
                       [&](const ElementCut& cut) { return comes_in(cut, duplicates); });
  if (chosen.empty())
    throw MapError(path + ": " + level.sentence + ": nothing of the building is there" +
                   left_out_at(building, classes, level.height_m) + unread(cuts) +
                   ", expected a storey or height that has walls (opal map storeys)");
  const std::vector<std::size_t> order = solids_in_order(chosen);
  std::vector<PlanSolid> solids;
  std::map<std::string, int> objects;
  for (const std::size_t k : order)
    solids.push_back(
        {chosen[k].solid, objects.try_emplace(chosen[k].object->id, static_cast<int>(objects.size())).first->second});
  const Plan plan = unite(solids);
  const AssembledMap assembled = assemble(name_of(path, level.storey), chosen, plan, order, duplicates,
                                          origin_of(building, level, chosen, cuts), options_.sensor);
  MapImport imported;
  imported.map = assembled.map;
  imported.elements = imported_elements(cuts, duplicates, assembled);
  imported.report = report(building, level, cuts, imported.elements, plan, assembled);
  imported.height_m = level.height_m;
  return imported;
}

std::vector<Storey> IfcImporter::storeys(const std::string& path) const {
  const Building building = building_of(path, options_.origin_m);
  std::vector<Storey> storeys;
  for (const Level& level : building.levels) {
    const double height_m = level.elevation_m + options_.sensor_height_m;
    storeys.push_back({level.id, level.name, level.elevation_m, height_m, counts_at(building, height_m)});
  }
  return storeys;
}

}  // namespace opal::ifc_importer
