// Real buildings, against outlines that an independent reader made of them at the same height.
#include "drawn_building.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>

using namespace opal;

namespace {

const std::filesystem::path kModels = std::filesystem::path(OPAL_SOURCE_DIR) / ".." / "shared" / "data" / "ifc";
constexpr double kTolerance_m = 0.02;

bool is_absent() {
  if (std::filesystem::exists(kModels / "slices")) return false;
  std::cout << "skipped: no building models in " << kModels.string() << '\n';
  return true;
}

double distance_m(const std::vector<Segment>& segments, const Point& p) {
  double nearest_m = 1e9;
  for (const Segment& s : segments)
    nearest_m = std::min(nearest_m, s.length_m() > 0 ? opal::distance_m(s, p) : (s.begin - p).norm());
  return nearest_m;
}

double farthest_m(const std::vector<Segment>& from, const std::vector<Segment>& to) {
  double farthest_m = 0;
  for (const Segment& s : from) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(s.length_m() / 0.05)));
    for (int k = 0; k <= pieces; ++k)
      farthest_m = std::max(farthest_m, distance_m(to, s.begin + (s.end - s.begin) * k / pieces));
  }
  return farthest_m;
}

std::vector<Segment> outline_of(const ImportedElement& element) {
  std::vector<Segment> outline = element.outline;
  for (const Circle& circle : outline.empty() ? element.circles : std::vector<Circle>())
    for (int k = 0; k < 64; ++k)
      outline.push_back({circle.center + circle.radius_m * unit_vector(k * std::numbers::pi / 32),
                         circle.center + circle.radius_m * unit_vector((k + 1) * std::numbers::pi / 32)});
  return outline;
}

struct Agreement {
  int total = 0, right = 0;
};

std::map<std::string, Agreement> compare(const nlohmann::json& reference, const MapImport& imported) {
  std::map<std::string, const ImportedElement*> by_id;
  for (const ImportedElement& element : imported.elements) by_id[element.id] = &element;
  std::map<std::string, Agreement> agreement;
  for (const auto& expected : reference.at("elements")) {
    const std::string kind = expected.at("cls").get<std::string>().substr(0, 7);  // IFCWALL of IFCWALLSTANDARDCASE
    Agreement& of_kind = agreement[kind];
    ++of_kind.total;
    const auto found = by_id.find(expected.at("guid").get<std::string>());
    if (found == by_id.end()) continue;
    std::vector<Segment> outline;
    for (const auto& s : expected.at("segs").get<std::vector<std::array<double, 4>>>())
      outline.push_back({{s[0], s[1]}, {s[2], s[3]}});
    const std::vector<Segment> own = outline_of(*found->second);
    if (own.empty()) continue;
    const double off_m = std::max(farthest_m(outline, own), farthest_m(own, outline));
    of_kind.right += off_m <= kTolerance_m + (found->second->outline.empty() ? 0.01 : 0);
    if (off_m > kTolerance_m + 0.01) UNSCOPED_INFO(kind << ' ' << found->first << " is off by " << off_m << " m");
  }
  return agreement;
}

nlohmann::json read(const std::filesystem::path& path) { return nlohmann::json::parse(std::ifstream(path)); }

}  // namespace

TEST_CASE("walls, columns, doors and windows of real buildings lie where an independent reader puts them") {
  if (is_absent()) return;
  for (const auto& entry : std::filesystem::directory_iterator(kModels / "slices")) {
    const nlohmann::json reference = read(entry.path());
    const std::string file = reference.at("file");
    CAPTURE(file);
    const MapImport imported = ifc_importer({{"z_m", reference.at("z")}})->import((kModels / file).string());
    auto agreement = compare(reference, imported);
    const auto &walls = agreement["IFCWALL"], &columns = agreement["IFCCOLU"], &doors = agreement["IFCDOOR"],
               &windows = agreement["IFCWIND"];
    CHECK(walls.right >= 0.99 * walls.total);
    CHECK(columns.right == columns.total);
    CHECK(doors.right >= 0.95 * doors.total);
    CHECK(windows.right >= 0.95 * windows.total);
  }
}

TEST_CASE("the columns of a real hall are 46 circles of 15 cm") {
  if (is_absent()) return;
  const MapImport imported =
      ifc_importer({{"storey", "Level 1"}})->import((kModels / "HHS_Office_construction.ifc").string());
  const auto rims = all_of(*imported.map, GeometryKind::circle);
  CHECK(rims.size() == 46);
  for (const MapFeature* rim : rims) CHECK(std::get<Circle>(rim->geometry).radius_m == Approx(0.15).margin(1e-6));
  int merged = 0;
  for (const MapObject& object : imported.map->objects()) merged += static_cast<int>(object.notes.merged_ids.size());
  CHECK(merged == 85);
}

TEST_CASE("columns on a grid stand on its crossings") {
  if (is_absent()) return;
  const MapImport imported = ifc_importer({{"z_m", 1}})->import((kModels / "grid-placement_4x3.ifc").string());
  int columns = 0;
  for (const MapObject& object : imported.map->objects()) columns += object.type == "opal:Column";
  CHECK(columns == 25);
}

TEST_CASE("faces of real buildings that meet share a point, and no gap below a centimetre is left between them") {
  if (is_absent()) return;
  for (const std::string file :
       {"Office_A_20110811.ifc", "Duplex.ifc", "TallBuilding.ifc", "LargeBuilding.ifc", "simple_room_v6.ifc"}) {
    CAPTURE(file);
    const MapImport imported = ifc_importer()->import((kModels / file).string());
    std::map<std::string, Point> points;
    for (const MapFeature* feature : all_of(*imported.map, GeometryKind::segment)) {
      const auto& segment = std::get<Segment>(feature->geometry);
      points[feature->points[0]] = segment.begin;
      points[feature->points[1]] = segment.end;
    }
    int near = 0;
    for (auto a = points.begin(); a != points.end(); ++a)
      for (auto b = std::next(a); b != points.end(); ++b) near += (a->second - b->second).norm() < 0.0099;
    CHECK(near == 0);
  }
}
