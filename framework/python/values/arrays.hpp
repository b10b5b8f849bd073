#pragma once

#include <opal/common/geometry.hpp>

#include <pybind11/numpy.h>

#include <span>
#include <vector>

namespace opal::python {

using Array = pybind11::array_t<double>;
using IntArray = pybind11::array_t<int>;
/// What callers give: whatever numpy makes an array of doubles of.
using GivenArray = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
/// The same of ranges.
using GivenRanges = pybind11::array_t<float, pybind11::array::c_style | pybind11::array::forcecast>;

/// Shape (3,): x [m], y [m], heading [rad].
Array array_of(const Pose2& pose);
/// Shape (N, 2) [m].
Array array_of(std::span<const Point> points);
/// Shape (N,).
Array array_of(std::span<const double> numbers);
Array array_of(const Eigen::Matrix3d& matrix);  ///< shape (3, 3)
/// Shape (rows, columns), row by row. @param numbers  rows * columns of them.
Array table_of(std::span<const double> numbers, std::size_t columns);
/// Shape (N,).
IntArray array_of(std::span<const int> numbers);

/// @param name  of the argument. @throws std::invalid_argument (ValueError) if it is no array of three.
Pose2 pose_of(const GivenArray& numbers, const char* name);
/// One dimension, any length. @throws std::invalid_argument likewise.
std::vector<float> ranges_of(const GivenRanges& ranges, const char* name);

/// "segment": the name of a shape.
const char* kind_name(const Geometry& geometry);
/// Point (x, y); OrientedPoint (x, y, heading, opening); Segment (x, y, x, y): begin, end; Circle (x, y, radius).
std::vector<double> numbers_of(const Geometry& geometry);

}  // namespace opal::python
