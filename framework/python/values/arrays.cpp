#include "python/values/arrays.hpp"

#include <algorithm>
#include <stdexcept>

namespace opal::python {

namespace py = pybind11;

namespace {

std::string shape_text(const py::array& array) {
  std::string text;
  for (py::ssize_t k = 0; k < array.ndim(); ++k) text += (k > 0 ? ", " : "") + std::to_string(array.shape(k));
  return "(" + text + (array.ndim() == 1 ? ",)" : ")");
}

[[noreturn]] void refuse(const char* name, const py::array& found, const char* expected) {
  throw std::invalid_argument(std::string(name) + ": an array of shape " + shape_text(found) + ", expected " +
                              expected);
}

template <class Number>
py::array_t<Number> copied(std::span<const Number> numbers) {
  py::array_t<Number> array(static_cast<py::ssize_t>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array.mutable_data());
  return array;
}

}  // namespace

Array array_of(const Pose2& pose) {
  const double numbers[] = {pose.x(), pose.y(), pose.heading_rad()};
  return copied<double>(numbers);
}

Array array_of(std::span<const Point> points) {
  Array array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  double* out = array.mutable_data();
  for (const Point& point : points) {
    *out++ = point.x();
    *out++ = point.y();
  }
  return array;
}

Array array_of(std::span<const double> numbers) { return copied(numbers); }
IntArray array_of(std::span<const int> numbers) { return copied(numbers); }

Array array_of(const Eigen::Matrix3d& matrix) {
  Array array({py::ssize_t{3}, py::ssize_t{3}});
  for (py::ssize_t row = 0; row < 3; ++row)
    for (py::ssize_t column = 0; column < 3; ++column) array.mutable_at(row, column) = matrix(row, column);
  return array;
}

Array table_of(std::span<const double> numbers, std::size_t columns) {
  Array array({static_cast<py::ssize_t>(numbers.size() / columns), static_cast<py::ssize_t>(columns)});
  std::copy(numbers.begin(), numbers.end(), array.mutable_data());
  return array;
}

Pose2 pose_of(const GivenArray& numbers, const char* name) {
  if (numbers.ndim() != 1 || numbers.size() != 3) refuse(name, numbers, "x [m], y [m], heading [rad]: shape (3,)");
  const double* pose = numbers.data();
  return {pose[0], pose[1], pose[2]};
}

std::vector<float> ranges_of(const GivenRanges& ranges, const char* name) {
  if (ranges.ndim() != 1) refuse(name, ranges, "one range [m] per beam: shape (N,)");
  return {ranges.data(), ranges.data() + ranges.size()};
}

const char* kind_name(const Geometry& geometry) {
  constexpr const char* names[] = {"point", "oriented_point", "segment", "circle"};
  return names[geometry.index()];
}

namespace {

struct Numbers {
  std::vector<double> operator()(const Point& p) const { return {p.x(), p.y()}; }
  std::vector<double> operator()(const OrientedPoint& p) const {
    return {p.position.x(), p.position.y(), p.heading_rad, p.opening_rad};
  }
  std::vector<double> operator()(const Segment& s) const { return {s.begin.x(), s.begin.y(), s.end.x(), s.end.y()}; }
  std::vector<double> operator()(const Circle& c) const { return {c.center.x(), c.center.y(), c.radius_m}; }
};

}  // namespace

std::vector<double> numbers_of(const Geometry& geometry) { return std::visit(Numbers{}, geometry); }

}  // namespace opal::python
