#include "evaluation/site.hpp"
#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <set>

namespace opal {
namespace {

using Json = nlohmann::json;

constexpr double kUsableRange_m = 30.0;
constexpr int kMostBeams = 100'000;

[[noreturn]] void refuse(const std::string& path, const std::string& pointer, const std::string& found,
                         const std::string& expected) {
  throw ConfigError(path + ": " + (pointer.empty() ? "(root)" : pointer) + ": " + found + ", expected " + expected);
}

std::string shown(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  constexpr std::size_t kLongest = 40;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

/// A place in a document that can say where it is.
class Place {
 public:
  Place(const std::string& path, std::string pointer, const Json& value)
      : path_(path), pointer_(std::move(pointer)), value_(value) {}

  Place member(const std::string& name, const std::string& expected) const {
    if (!value_.is_object()) refuse(path_, pointer_, shown(value_), "an object");
    const auto found = value_.find(name);
    if (found == value_.end()) refuse(path_, pointer_ + "/" + name, "missing", expected);
    return {path_, pointer_ + "/" + name, *found};
  }
  bool has(const std::string& name) const { return value_.is_object() && value_.contains(name); }
  std::vector<Place> elements() const {
    if (!value_.is_array()) fail("an array");
    std::vector<Place> places;
    for (std::size_t i = 0; i < value_.size(); ++i)
      places.emplace_back(path_, pointer_ + "/" + std::to_string(i), value_[i]);
    return places;
  }
  double number(double minimum, double maximum, const std::string& expected) const {
    if (!value_.is_number()) fail(expected);
    const double number = value_.get<double>();
    if (!(number >= minimum && number <= maximum)) fail(expected);
    return number;
  }
  int count(int maximum) const {
    const std::string expected = std::string("an integer in [1, ").append(std::to_string(maximum)).append("]");
    if (!value_.is_number_integer()) fail(expected);
    return static_cast<int>(number(1, maximum, expected));
  }
  std::string text() const {
    if (!value_.is_string() || value_.get_ref<const std::string&>().empty()) fail("a string that is not empty");
    return value_.get<std::string>();
  }
  [[noreturn]] void fail(const std::string& expected) const { refuse(path_, pointer_, shown(value_), expected); }

 private:
  const std::string& path_;
  std::string pointer_;
  const Json& value_;
};

double number_in(const Place& object, const std::string& name, double minimum, double maximum,
                 const std::string& expected) {
  return object.member(name, expected).number(minimum, maximum, expected);
}

}  // namespace

LaserModel read_site_laser(const std::string& path) {
  const Json document = read_json(path);
  const Place laser = Place(path, "", document).member("laser", "an object");
  LaserModel model;
  model.beams = laser.member("n_beams", "an integer").count(kMostBeams);
  model.angle_min_rad = radians(number_in(laser, "angle_min_deg", -360, 360, "degrees in [-360, 360]"));
  model.angle_increment_rad = radians(number_in(laser, "angle_increment_deg", 1e-6, 90, "degrees in (0, 90]"));
  model.no_return_m = number_in(laser, "no_return_at_or_above_m", model.range_min_m, 1e6, "metres, more than 0.05");
  model.range_max_m = std::min(model.no_return_m, kUsableRange_m);
  if (laser.has("range_max_m"))
    model.range_max_m =
        std::min(model.range_max_m, number_in(laser, "range_max_m", model.range_min_m, 1e6, "metres, more than 0.05"));
  if (laser.has("sweep_s")) model.sweep_s = number_in(laser, "sweep_s", 0, 10, "seconds in [0, 10]");
  const std::string offset = "metres in [-100, 100]";
  model.T_base_laser =
      Pose2(number_in(laser, "offset_x_m", -100, 100, offset), number_in(laser, "offset_y_m", -100, 100, offset),
            number_in(laser, "offset_theta", -7, 7, "radians in [-7, 7]"));
  return model;
}

std::vector<Query> read_queries(const std::string& path) {
  const Json document = read_json(path);
  std::vector<Query> queries;
  std::set<std::string> ids;
  for (const Place& place : Place(path, "", document).member("queries", "an array").elements()) {
    const Place id = place.member("id", "a string");
    if (!ids.insert(id.text()).second) id.fail("an id that no other query has");
    Query query{id.text(), number_in(place, "start_time", -1e12, 1e12, "seconds"), 0};
    query.end_s = number_in(place, "end_time", query.start_s, 1e12, "seconds, not before start_time");
    queries.push_back(std::move(query));
  }
  return queries;
}

}  // namespace opal
