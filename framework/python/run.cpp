#include "python/run.hpp"

#include "common/text_file.hpp"
#include "python/bindings.hpp"

namespace opal::python {

namespace py = pybind11;

namespace {

/// The columns of results.csv, by its names: a storey only where a row has one.
py::dict columns_of(const benchmark::RunRecord& run) {
  std::vector<double> stamps, xs, ys, headings, probabilities, nones;
  py::list queries, statuses, flags, storeys;
  bool has_storeys = false;
  for (const ResultRow& row : run.rows) {
    queries.append(row.query);
    stamps.push_back(row.stamp_s);
    xs.push_back(row.T_map_laser.x());
    ys.push_back(row.T_map_laser.y());
    headings.push_back(row.T_map_laser.heading_rad());
    flags.append(row.localized());
    probabilities.push_back(row.probability);
    nones.push_back(row.none);
    statuses.append(name_of(row.status));
    storeys.append(row.storey);
    has_storeys |= !row.storey.empty();
  }
  const auto array = [](const std::vector<double>& numbers) { return array_of(std::span<const double>(numbers)); };
  using namespace py::literals;
  py::dict columns("query_id"_a = queries, "timestamp"_a = array(stamps), "x"_a = array(xs), "y"_a = array(ys),
                   "theta"_a = array(headings), "localized_flag"_a = flags, "probability"_a = array(probabilities),
                   "none"_a = array(nones), "status"_a = statuses);
  if (has_storeys) columns["storey"] = storeys;
  return columns;
}

Array trajectory_of(const benchmark::RunRecord& run) {
  std::vector<double> rows;
  for (const StampedPose& at : run.trajectory)
    rows.insert(rows.end(), {at.stamp_s, at.pose.x(), at.pose.y(), at.pose.heading_rad()});
  return table_of(rows, 4);
}

void write_rows(const benchmark::RunRecord& run, const std::string& path) {
  write_with(path, [&](std::ostream& out) { write_results(out, run.rows); });
}

void write_others(const benchmark::RunRecord& run, const std::string& path) {
  write_with(path, [&](std::ostream& out) { write_alternatives(out, run.alternatives); });
}

py::object localized_after(const benchmark::RunRecord& run) {
  if (!run.localized_after) return py::none();
  return py::make_tuple(run.localized_after->driven_m, run.localized_after->time_s);
}

}  // namespace

py::object data_frame(const py::object& columns) { return py::module_::import("pandas").attr("DataFrame")(columns); }

void bind_run(py::module_& module) {
  py::class_<benchmark::RunRecord>(module, "Run",
                                   "What replays through a localizer have left: a row per scan that had a pose.")
      .def(
          "columns", &columns_of,
          "The columns of results.csv as arrays and lists: query_id, timestamp, x, y, theta (of the first LASER in the "
          "map), localized_flag, probability, none, status; and storey, if the map holds storeys.")
      .def(
          "frame", [](const benchmark::RunRecord& self) { return data_frame(columns_of(self)); },
          "The same as a pandas.DataFrame; needs pandas.")
      .def_property_readonly("trajectory", &trajectory_of,
                             "Stamp [s], x, y [m], heading [rad] of the ROBOT in the map; shape (N, 4).")
      .def_property_readonly(
          "cpu_ms",
          [](const benchmark::RunRecord& self) { return array_of(std::span<const double>(self.update_cpu_ms)); },
          "CPU time of each keyframe; shape (K,).")
      .def_property_readonly("localized_after", &localized_after,
                             "Of the newest replay: (metres, seconds) until it was localized; None: never.")
      .def_property_readonly(
          "last", [](const benchmark::RunRecord& self) { return self.last; }, "The newest estimate.")
      .def("write_results", &write_rows, py::arg("path"), "Writes results.csv as `opal localize` does.")
      .def("write_alternatives", &write_others, py::arg("path"), "Writes alternatives.csv as `opal bench` does.")
      .def("__len__", [](const benchmark::RunRecord& self) { return self.rows.size(); })
      .def("__repr__", [](const benchmark::RunRecord& self) {
        return "<opal.Run: " + std::to_string(self.rows.size()) + " poses, " +
               std::to_string(self.update_cpu_ms.size()) + " keyframes>";
      });
}

}  // namespace opal::python
