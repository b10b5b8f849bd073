#include "python/values/map_arrays.hpp"

namespace opal::python {

Array shape_table(const SemanticMap& map, GeometryKind kind, const std::optional<std::string>& type,
                  const std::optional<std::string>& sensor) {
  constexpr std::size_t columns[] = {2, 4, 4, 3};
  std::vector<double> rows;
  for (const MapFeature& feature : map.features()) {
    if (kind_of(feature.geometry) != kind || (type && feature.type != *type) || (sensor && feature.sensor != *sensor))
      continue;
    const std::vector<double> row = numbers_of(feature.geometry);
    rows.insert(rows.end(), row.begin(), row.end());
  }
  return table_of(rows, columns[static_cast<std::size_t>(kind)]);
}

}  // namespace opal::python
