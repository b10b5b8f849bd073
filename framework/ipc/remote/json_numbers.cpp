#include "ipc/remote/json_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal::remote {

using nlohmann::json;

std::vector<double> numbers_in(ConfigObject& object, const std::string& key, std::size_t count) {
  const json& list = object.any(key);
  const bool numbers = list.is_array() && list.size() == count &&
                       std::all_of(list.begin(), list.end(), [](const json& one) { return one.is_number(); });
  if (!numbers) object.refuse(key, fmt::format("{} numbers", count));
  return list.get<std::vector<double>>();
}

double number_in(ConfigObject& object, const std::string& key, NumberRange range) {
  if (object.any(key).is_null()) object.refuse(key, "a number");
  return object.number(key, 0, range);
}

Pose2 pose_in(ConfigObject& object, const std::string& key) {
  const std::vector<double> n = numbers_in(object, key, 3);
  return {n[0], n[1], n[2]};
}

Geometry geometry_in(ConfigObject& object) {
  const auto has = [&](const char* key) { return !object.any(key).is_null(); };
  const auto numbers = [&](const char* key, std::size_t count) { return numbers_in(object, key, count); };
  Geometry geometry;
  if (has("circle")) {
    const auto n = numbers("circle", 3);
    geometry = Circle{{n[0], n[1]}, n[2]};
  } else if (has("segment")) {
    const auto n = numbers("segment", 4);
    geometry = Segment{{n[0], n[1]}, {n[2], n[3]}};
  } else if (has("oriented_point")) {
    const auto n = numbers("oriented_point", 4);
    geometry = OrientedPoint{{n[0], n[1]}, n[2], n[3]};
  } else {
    const auto n = numbers("point", 2);
    geometry = Point(n[0], n[1]);
  }
  object.expect_no_more();
  return geometry;
}

}  // namespace opal::remote
