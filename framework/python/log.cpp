#include "benchmark/runs/recorded_log.hpp"
#include "python/bindings.hpp"
#include "python/plugins.hpp"
#include "python/replay.hpp"
#include "python/values/arrays.hpp"
#include "sensing/log_check.hpp"

#include <pybind11/stl.h>

#include <limits>

namespace opal::python {

namespace py = pybind11;

namespace {

using LogPtr = std::shared_ptr<benchmark::RecordedLog>;
constexpr double kForever = std::numeric_limits<double>::infinity();

LogPtr read_log(const std::string& path, const std::optional<Deployment>& deployment,
                const std::map<std::string, std::string>& options) {
  std::vector<std::string> words;
  for (const auto& [name, value] : options) words.push_back(name + "=" + value);
  const py::gil_scoped_release others_run;
  return std::make_shared<benchmark::RecordedLog>(
      benchmark::read_recorded_log(*registry(), path, deployment.value_or(Deployment()), words));
}

std::vector<LaserModel> lasers_of(const benchmark::RecordedLog& log, const Deployment& deployment) {
  return lasers_of_log(log.records, deployment.lasers, log.file, deployment.file + ": /sensor");
}

std::vector<RawScan> raw_scans(const benchmark::RecordedLog& log) {
  std::vector<RawScan> scans;
  for (const LogRecord& record : log.records)
    if (const auto* scan = std::get_if<RawScan>(&record)) scans.push_back(*scan);
  return scans;
}

Array odometry_of(const benchmark::RecordedLog& log) {
  std::vector<double> rows;
  const auto add = [&](double stamp_s, const Pose2& pose) {
    rows.insert(rows.end(), {stamp_s, pose.x(), pose.y(), pose.heading_rad()});
  };
  for (const LogRecord& record : log.records) {
    if (const auto* odometry = std::get_if<OdometryRecord>(&record)) add(odometry->stamp_s, odometry->T_odom_base);
    if (const auto* scan = std::get_if<RawScan>(&record); scan && scan->T_odom_base)
      add(scan->stamp_s, *scan->T_odom_base);
  }
  return table_of(rows, 4);
}

void bind_raw_scan(py::module_& module) {
  py::class_<RawScan>(module, "RawScan", "One sweep as recorded; invalid and missing ranges still in it.")
      .def_readonly("stamp_s", &RawScan::stamp_s)
      .def_readonly("frame", &RawScan::frame)
      .def_property_readonly(
          "ranges_m",
          [](const RawScan& self) {
            return py::array_t<float>(static_cast<py::ssize_t>(self.ranges_m.size()), self.ranges_m.data());
          },
          "By beam; NaN, 0, negative and infinite all occur; shape (N,), float32.")
      .def_property_readonly(
          "odometry",
          [](const RawScan& self) -> py::object {
            if (!self.T_odom_base) return py::none();
            return array_of(*self.T_odom_base);
          },
          "Recorded with the scan, frame odom; shape (3,), or None.");
}

void bind_replay(py::module_& module) {
  py::class_<ReplayHandle>(module, "Replay", "Gives one sample after the other, each with the odometry at its stamp.")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__",
           [](ReplayHandle& self) {
             std::optional<Sample> sample;
             {
               const py::gil_scoped_release others_run;
               sample = self.replay.next();
             }
             if (!sample) throw py::stop_iteration();
             return *std::move(sample);
           })
      .def_property_readonly(
          "counts", [](const ReplayHandle& self) { return self.replay.counts(); },
          "How often something odd was met so far, by cause.")
      .def_property_readonly(
          "progress", [](const ReplayHandle& self) { return self.replay.progress(); },
          "Share of the log already walked, in [0, 1].");
}

std::unique_ptr<ReplayHandle> samples(const LogPtr& log, const std::vector<LaserModel>& lasers, double from_s,
                                      double to_s) {
  ReplayOptions window;
  window.from_s = from_s;
  window.to_s = to_s;
  return std::make_unique<ReplayHandle>(ReplayHandle{log, lasers, Replay(log->records, lasers, window)});
}

}  // namespace

void bind_log(py::module_& module) {
  bind_raw_scan(module);
  bind_replay(module);
  const auto from_s = py::arg("from_s") = -kForever;
  const auto to_s = py::arg("to_s") = kForever;
  py::class_<benchmark::RecordedLog, LogPtr>(module, "Log", "A recorded log, all of it in memory.")
      .def_readonly("file", &benchmark::RecordedLog::file)
      .def_readonly("defects", &benchmark::RecordedLog::defects, "What was skipped, by cause.")
      .def("raw_scans", &raw_scans, "All scans as recorded, in file order.")
      .def_property_readonly("odometry", &odometry_of,
                             "Stamp [s], x, y [m], heading [rad] in the frame odom, in file order; shape (N, 4).")
      .def("lasers", &lasers_of, py::arg("deployment"),
           "The lasers of a deployment, with what the log states of them. Raises opal.ConfigError where they differ.")
      .def("samples", &samples, py::arg("lasers"), from_s, to_s,
           "Scans with odometry, by increasing stamp. Records outside [from_s, to_s] are not looked at.")
      .def(
          "samples",
          [](const LogPtr& self, const Deployment& deployment, double from, double to) {
            return samples(self, lasers_of(*self, deployment), from, to);
          },
          py::arg("deployment"), from_s, to_s)
      .def("__repr__", [](const benchmark::RecordedLog& self) {
        return "<opal.Log " + self.file + ": " + std::to_string(self.records.size()) + " records>";
      });
  module.def("read_log", &read_log, py::arg("path"), py::arg("deployment") = py::none(),
             py::arg("options") = std::map<std::string, std::string>(),
             "Reads a log in any format that a plugin knows: CARMEN text, MCAP, bags of ROS 1 and 2.\n\n"
             "deployment: says which lasers to look for, and has options of log sources.\n"
             "options: of the log's source, before those of the deployment. Raises opal.LogError.");
}

}  // namespace opal::python
