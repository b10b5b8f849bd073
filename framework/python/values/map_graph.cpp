#include "python/values/map_graph.hpp"

#include "python/values/arrays.hpp"

#include <map>

namespace opal::python {

namespace py = pybind11;
using namespace py::literals;

namespace {

/// Objects first, then features, points and patterns, each in the order of the map.
class Graph {
 public:
  explicit Graph(const SemanticMap& map) : map_(map) {
    add_objects();
    add_features();
    add_points();
    add_patterns();
  }
  py::tuple nodes_and_edges() const { return py::make_tuple(nodes_, edges_); }

 private:
  std::size_t feature_node(MapFeatureNumber number) const {
    return map_.objects().size() + static_cast<std::size_t>(number.number());
  }
  void connect(std::size_t from, std::size_t to, const char* kind) { edges_.append(py::make_tuple(from, to, kind)); }

  void add_objects() {
    for (const MapObject& object : map_.objects())
      nodes_.append(
          py::dict("kind"_a = "object", "id"_a = object.id, "type"_a = object.type, "name"_a = object.notes.name));
  }

  void add_features() {
    for (const MapFeature& feature : map_.features()) {
      connect(static_cast<std::size_t>(feature.object.number()), nodes_.size(), "perceived_by");
      nodes_.append(py::dict("kind"_a = "feature", "id"_a = feature.id, "type"_a = feature.type,
                             "sensor"_a = feature.sensor, "shape"_a = kind_name(feature.geometry),
                             "numbers"_a = array_of(std::span<const double>(numbers_of(feature.geometry)))));
    }
  }

  void add_points() {
    std::map<std::string, std::size_t> points;
    for (std::size_t k = 0; k < map_.features().size(); ++k)
      for (const std::string& id : map_.features()[k].points) {
        const auto [point, is_new] = points.try_emplace(id, nodes_.size());
        if (is_new) nodes_.append(py::dict("kind"_a = "point", "id"_a = id));
        connect(map_.objects().size() + k, point->second, "made_of");
      }
  }

  void add_patterns() {
    std::map<std::string, std::size_t> patterns;
    for (const MapPattern& pattern : map_.patterns()) {
      patterns[pattern.id] = nodes_.size();
      nodes_.append(py::dict("kind"_a = "pattern", "id"_a = pattern.id, "type"_a = pattern.pattern_template));
    }
    for (const MapPattern& pattern : map_.patterns()) {
      for (const MapFeatureNumber feature : pattern.features)
        connect(patterns.at(pattern.id), feature_node(feature), "member");
      for (const std::string& part : pattern.subpatterns)
        if (patterns.contains(part)) connect(patterns.at(pattern.id), patterns.at(part), "subpattern");
    }
  }

  const SemanticMap& map_;
  py::list nodes_, edges_;
};

}  // namespace

py::tuple map_graph(const SemanticMap& map) { return Graph(map).nodes_and_edges(); }

}  // namespace opal::python
