#include "python/bindings.hpp"
#include "python/map.hpp"

#include "map_tools/test_maps/map_damage.hpp"
#include "simulation/buildings/building.hpp"
#include "simulation/drives/recording.hpp"
#include "simulation/drives/storey_drives.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <optional>

namespace opal::python {

namespace py = pybind11;
namespace sim = opal::simulation;

namespace {

MapHandle generated(const std::string& kind, std::uint64_t seed, double size_m2, double symmetry) {
  return {sim::generate_building({kind, seed, size_m2, symmetry}).map};
}

std::shared_ptr<const SemanticMap> as_built(const MapHandle& map, const std::string& words, std::uint64_t seed) {
  if (words.empty()) return map.map;
  MapDamage damage = read_map_damage(words);
  damage.seed = seed;
  return damaged_map(*map.map, damage);
}

void take_lasers(const std::vector<LaserModel>& lasers, sim::SimulationOptions& world) {
  if (lasers.empty()) throw ConfigError("simulate: lasers: none, expected one at least");
  world.take(lasers);
}

/// As `opal simulate` drives: on every storey of a map that holds several.
sim::Recording driven(const SemanticMap& map, const std::shared_ptr<const SemanticMap>& building,
                      const sim::SimulationOptions& world, const sim::DriveOptions& drives, std::uint64_t seed) {
  if (!map.origin().storeys.empty()) return sim::record_on_storeys(*building, world, drives, seed);
  sim::Simulation simulation(building, world, seed);
  return sim::record(simulation, drives, Random(seed).branch());
}

/// The ranges are those of `opal simulate`.
template <class Number>
Number in_range(const char* name, Number value, Number least, Number most) {
  if (value >= least && value <= most) return value;
  throw ConfigError(fmt::format("simulate: {}: {}, expected a number from {} to {}", name, value, least, most));
}

sim::ClutterOptions clutter_of(double level, double along_walls) {
  sim::ClutterOptions clutter;
  clutter.level = in_range("clutter", level, 0.0, 100.0);
  clutter.along_walls = in_range("along_walls", along_walls, 0.0, sim::kMostAlongWalls);
  return clutter;
}

py::dict summary_of_drives(const sim::Recording& recording) {
  using namespace py::literals;
  py::list queries;
  for (const Query& query : recording.queries) queries.append(query.id);
  return py::dict("queries"_a = queries, "distances_m"_a = recording.distances_m, "scans"_a = recording.scans.size(),
                  "stops"_a = recording.stops);
}

py::dict simulate(const MapHandle& map, const std::string& prefix, int drives, double distance_m, double clutter,
                  double along_walls, int people, double doors_open, const std::string& damage,
                  const std::optional<std::vector<LaserModel>>& lasers, std::uint64_t seed) {
  sim::SimulationOptions world;
  world.clutter = clutter_of(clutter, along_walls);
  world.people = in_range("people", people, 0, 1000);
  world.doors_open_share = in_range("doors_open", doors_open, 0.0, 1.0);
  if (lasers) take_lasers(*lasers, world);
  sim::DriveOptions way;
  way.drives = in_range("drives", drives, 1, 100000);
  way.distance_m = in_range("distance_m", distance_m, 0.1, 100000.0);
  sim::Recording recording;
  {
    const py::gil_scoped_release others_run;
    recording = driven(*map.map, as_built(map, damage, seed), world, way, seed);
    sim::write_recorded_place(recording, *map.map, prefix);
  }
  return summary_of_drives(recording);
}

constexpr const char* kAboutSimulate =
    "Drives through a building and writes a recording with ground truth, as `opal simulate MAP -o PREFIX` does: the "
    "same seed gives the same files. `opal.bench(prefix)` runs it.\n\n"
    "map: what the robot knows; damage: how the building differs from it, in the words of `opal simulate --damage`.\n"
    "prefix: of the files to write. drives: number; distance_m: of each [m].\n"
    "clutter: how much stands about that the map does not hold; 1: everyday. people: who walk about.\n"
    "along_walls: share of the walls that stand behind machines, boxes, benches and bins, 0 to 0.95.\n"
    "doors_open: share. lasers: opal.Laser of the robot; None: 270 degrees, up to 30 m.\n"
    "Returns a dict: queries (their ids), distances_m, scans (number), stops (how often somebody was in the way).\n"
    "Raises opal.Error, opal.WriteError.";

}  // namespace

void bind_simulation(py::module_& module) {
  const sim::SimulationOptions world;
  const sim::DriveOptions way;
  module.def("generate_building", &generated, py::arg("kind"), py::arg("seed") = 0, py::arg("size_m2") = 0.0,
             py::arg("symmetry") = sim::BuildingRequest().symmetry, py::call_guard<py::gil_scoped_release>(),
             "A building of our own, as `opal map generate` makes it: the same seed gives the same building.\n\n"
             "kind: office, hall, warehouse, corridor, atlas, gemini. size_m2: about how large; 0: as is usual.\n"
             "symmetry: 0: all parts differ; 1: all are copies of one. Raises opal.ConfigError.");
  module.def("simulate", &simulate, py::arg("map"), py::arg("prefix"), py::kw_only(), py::arg("drives") = way.drives,
             py::arg("distance_m") = way.distance_m, py::arg("clutter") = world.clutter.level,
             py::arg("along_walls") = world.clutter.along_walls, py::arg("people") = world.people,
             py::arg("doors_open") = world.doors_open_share, py::arg("damage") = "", py::arg("lasers") = py::none(),
             py::arg("seed") = 1, kAboutSimulate);
}

}  // namespace opal::python
