#include "python/scan.hpp"
#include "python/bindings.hpp"
#include "python/values/arrays.hpp"

#include "deployment/mount_document.hpp"
#include "evaluation/site.hpp"

#include <opal/deployment/deployment.hpp>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

#include <stdexcept>

namespace opal::python {

namespace py = pybind11;

namespace {

/// A laser as a deployment describes it, with the same defaults and checks.
LaserModel make_laser(int beams, double angle_min_rad, double angle_increment_rad, const GivenArray& mount,
                      double range_min_m, double range_max_m, double no_return_m, const std::string& id,
                      const std::string& frame) {
  nlohmann::json sensor = {{"beams", beams},
                           {"angle_min_rad", angle_min_rad},
                           {"angle_increment_rad", angle_increment_rad},
                           {"range_min_m", range_min_m},
                           {"range_max_m", range_max_m},
                           {"no_return_m", no_return_m},
                           {"id", id},
                           {"T_base_laser", nlohmann::json(mount_document(pose_of(mount, "mount")))}};
  if (!frame.empty()) sensor["frame"] = frame;
  const nlohmann::json document = {{"@context", "urn:opal:v1"},
                                   {"@type", "opal:Deployment"},
                                   {"scorers", {{{"@type", "opal:Beams"}}}},
                                   {"sensor", sensor}};
  return parse_deployment(document.dump(), "opal.Laser").lasers.front();
}

void bind_laser(py::module_& module) {
  const LaserModel usual;
  const auto same = py::float_(usual.angle_increment_rad);
  py::class_<LaserModel>(module, "Laser", "What a planar LiDAR can see, and where it sits on the robot.")
      .def(py::init(&make_laser), py::kw_only(), py::arg("beams") = usual.beams,
           py::arg("angle_min_rad") = usual.angle_min_rad, py::arg("angle_increment_rad") = same,
           py::arg("mount") = py::make_tuple(0.0, 0.0, 0.0), py::arg("range_min_m") = usual.range_min_m,
           py::arg("range_max_m") = usual.range_max_m, py::arg("no_return_m") = usual.no_return_m,
           py::arg("id") = usual.id, py::arg("frame") = usual.frame,
           "mount: x, y, heading of the laser on the robot. Raises opal.ConfigError for numbers out of range.")
      .def_readonly("id", &LaserModel::id, "The sensor that map features are perceivable by.")
      .def_readonly("frame", &LaserModel::frame)
      .def_readonly("beams", &LaserModel::beams)
      .def_readonly("angle_min_rad", &LaserModel::angle_min_rad, "Bearing of beam 0, in the laser's frame.")
      .def_readonly("angle_increment_rad", &LaserModel::angle_increment_rad)
      .def_readonly("range_min_m", &LaserModel::range_min_m)
      .def_readonly("range_max_m", &LaserModel::range_max_m)
      .def_readonly("no_return_m", &LaserModel::no_return_m)
      .def_property_readonly(
          "mount", [](const LaserModel& self) { return array_of(self.T_base_laser); },
          "Where the laser sits in the robot's frame; shape (3,).")
      .def("sample", &sample_of_ranges, py::arg("ranges_m"), py::arg("odometry"), py::arg("stamp_s"), kSampleWords)
      .def("__repr__", [](const LaserModel& self) {
        return "<opal.Laser " + self.id + ": " + std::to_string(self.beams) + " beams>";
      });
  module.def("read_laser", &read_site_laser, py::arg("path"),
             "The laser of a recorded place, of its SITE.info.json. Raises opal.Error.");
}

template <class Member>
Array of_points(const Scan& scan, Member member) {
  std::vector<double> numbers;
  for (const ScanPoint& point : scan.points) numbers.push_back(point.*member);
  return array_of(std::span<const double>(numbers));
}

Array positions(const Scan& scan) {
  std::vector<Point> points;
  for (const ScanPoint& point : scan.points) points.push_back(point.position);
  return array_of(std::span<const Point>(points));
}

IntArray beams(const Scan& scan) {
  std::vector<int> numbers;
  for (const ScanPoint& point : scan.points) numbers.push_back(point.beam);
  return array_of(std::span<const int>(numbers));
}

void bind_cleaned_scan(py::module_& module) {
  py::class_<Scan>(module, "Scan", "One sweep, cleaned: hits by increasing bearing, in the laser's frame.")
      .def_readonly("stamp_s", &Scan::stamp_s)
      .def_property_readonly("points", &positions, "Hits [m]; shape (N, 2).")
      .def_property_readonly(
          "ranges_m", [](const Scan& self) { return of_points(self, &ScanPoint::range_m); }, "Of the hits; shape (N,).")
      .def_property_readonly(
          "bearings_rad", [](const Scan& self) { return of_points(self, &ScanPoint::bearing_rad); },
          "Of the hits, in [-pi, pi), increasing; shape (N,).")
      .def_property_readonly("beams", &beams, "Of the hits: numbers in the sweep as recorded; shape (N,).")
      .def_property_readonly(
          "free_bearings_rad",
          [](const Scan& self) { return array_of(std::span<const double>(self.free_bearings_rad)); },
          "Beams that hit nothing up to range_max_m; shape (M,).")
      .def_readonly("range_max_m", &Scan::range_max_m)
      .def_readonly("angle_increment_rad", &Scan::angle_increment_rad)
      .def_readonly("invalid", &Scan::invalid, "Number of beams that are neither hit nor free.")
      .def("__len__", [](const Scan& self) { return self.points.size(); })
      .def("__repr__",
           [](const Scan& self) { return "<opal.Scan: " + std::to_string(self.points.size()) + " points>"; });
}

void bind_sample(py::module_& module) {
  py::class_<LaserView>(module, "View", "What one laser saw.")
      .def_readonly("laser", &LaserView::laser, "Position among the deployment's lasers.")
      .def_property_readonly("scan", [](const LaserView& self) { return self.scan; })
      .def_property_readonly(
          "mount", [](const LaserView& self) { return array_of(self.T_base_laser); },
          "Where the laser was, in the robot's frame; shape (3,).");
  py::class_<Sample>(module, "Sample", "What the lasers saw at one time, with the odometry then.")
      .def_readonly("stamp_s", &Sample::stamp_s)
      .def_property_readonly(
          "odometry", [](const Sample& self) { return array_of(self.T_odom_base); },
          "Pose of the robot in the frame odom; shape (3,).")
      .def_readonly("views", &Sample::views, "By laser; at least one.")
      .def_property_readonly(
          "scan", [](const Sample& self) { return self.views.front().scan; }, "Of the first laser.")
      .def("__repr__", [](const Sample& self) {
        return "<opal.Sample at " + std::to_string(self.stamp_s) + " s, " + std::to_string(self.views.size()) +
               (self.views.size() == 1 ? " scan>" : " scans>");
      });
}

}  // namespace

const char* const kSampleWords =
    "One scan with odometry, for Localizer.update.\n\n"
    "ranges_m: by beam; NaN, infinite, 0 and negative all occur; shape (N,).\n"
    "odometry: the robot's pose in the frame odom; shape (3,).\nstamp_s: of the scan.";

Sample sample_of_ranges(const LaserModel& laser, const GivenRanges& ranges_m, const GivenArray& odometry,
                        double stamp_s) {
  const Pose2 T_odom_base = pose_of(odometry, "odometry");
  RawScan raw;
  raw.stamp_s = stamp_s;
  raw.ranges_m = ranges_of(ranges_m, "ranges_m");
  if (!raw.ranges_m.empty() && static_cast<int>(raw.ranges_m.size()) != laser.beams)
    throw std::invalid_argument("ranges_m: " + std::to_string(raw.ranges_m.size()) + " numbers, expected " +
                                std::to_string(laser.beams) + ", one for each beam of the laser, or none");
  return sample_of(make_scan(raw, laser), T_odom_base, laser.T_base_laser);
}

void bind_scan(py::module_& module) {
  bind_cleaned_scan(module);
  bind_sample(module);
  bind_laser(module);
}

}  // namespace opal::python
