#include "python/values/map_queries.hpp"

#include <stdexcept>

namespace opal::python {

namespace py = pybind11;

namespace {

/// Points of an array of shape (..., 2), one after the other.
class Points {
 public:
  Points(const GivenArray& array, const char* name) : numbers_(array.data()), count_(array.size() / 2) {
    if (array.ndim() == 0 || array.shape(array.ndim() - 1) != 2)
      throw std::invalid_argument(std::string(name) + ": " + std::to_string(array.ndim()) +
                                  " dimensions, the last one not 2, expected points: shape (..., 2)");
    shape_.assign(array.shape(), array.shape() + array.ndim() - 1);
  }
  py::ssize_t count() const { return count_; }
  const std::vector<py::ssize_t>& shape() const { return shape_; }  ///< of an answer per point
  Point operator[](py::ssize_t k) const { return {numbers_[2 * k], numbers_[2 * k + 1]}; }

 private:
  const double* numbers_;
  py::ssize_t count_;
  std::vector<py::ssize_t> shape_;
};

/// One point for all others, or one for each.
class Companions {
 public:
  Companions(const GivenArray& array, const Points& others, const char* name) : points_(array, name) {
    if (points_.count() != 1 && points_.count() != others.count())
      throw std::invalid_argument(std::string(name) + ": " + std::to_string(points_.count()) +
                                  " points, expected 1 or " + std::to_string(others.count()));
  }
  Point operator[](py::ssize_t k) const { return points_[points_.count() == 1 ? 0 : k]; }

 private:
  Points points_;
};

template <class Number, class Answer>
py::array_t<Number> answers(const Points& points, const Answer& answer) {
  py::array_t<Number> all(points.shape());
  Number* out = all.mutable_data();
  const py::gil_scoped_release others_run;
  for (py::ssize_t k = 0; k < points.count(); ++k) out[k] = answer(points[k], k);
  return all;
}

}  // namespace

Array clearances(const MapView& map, const GivenArray& points) {
  return answers<double>(Points(points, "points"), [&](const Point& p, py::ssize_t) { return map.clearance_m(p); });
}

Array likelihoods(const MapView& map, const GivenArray& points) {
  return answers<double>(Points(points, "points"),
                         [&](const Point& p, py::ssize_t) { return double(map.likelihood_field(p)); });
}

IntArray nearest_facing(const MapView& map, const GivenArray& points, const GivenArray& viewer) {
  const Points seen(points, "points");
  const Companions from(viewer, seen, "viewer");
  return answers<int>(seen, [&](const Point& p, py::ssize_t k) { return map.nearest_facing(p, p - from[k]).number(); });
}

py::tuple first_crossings(const MapView& map, const GivenArray& origin, const GivenArray& targets,
                          double min_penetration_m) {
  const Points to(targets, "targets");
  const Companions from(origin, to, "origin");
  std::vector<MapView::Crossing> crossings(static_cast<std::size_t>(to.count()));
  const IntArray features = answers<int>(to, [&](const Point& p, py::ssize_t k) {
    auto& crossing = crossings[static_cast<std::size_t>(k)] = map.first_crossing(from[k], p, min_penetration_m);
    return crossing.feature.number();
  });
  const auto at = [&](py::ssize_t k) -> const MapView::Crossing& { return crossings[static_cast<std::size_t>(k)]; };
  return py::make_tuple(features, answers<double>(to, [&](const Point&, py::ssize_t k) { return at(k).range_m; }),
                        answers<bool>(to, [&](const Point&, py::ssize_t k) { return at(k).from_behind; }));
}

}  // namespace opal::python
