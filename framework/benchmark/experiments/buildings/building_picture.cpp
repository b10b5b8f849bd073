#include "benchmark/experiments/buildings/building_picture.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace opal::experiments {
namespace {

/// Numbers in a picture are centimetres, y downwards.
std::string coordinates(const Point& p) {
  return fmt::format("{} {}", std::lround(100 * p.x()), std::lround(-100 * p.y()));
}

std::string view_box_of(const SemanticMap& map) {
  constexpr double kBorder_m = 1;
  Eigen::AlignedBox2d extent;
  for (const MapFeature& feature : map.features()) {
    const auto* face = std::get_if<Segment>(&feature.geometry);
    extent.extend(face ? face->begin : anchor_of(feature.geometry));
    if (face) extent.extend(face->end);
  }
  const Point low = extent.min() - Point::Constant(kBorder_m), size = extent.max() + Point::Constant(kBorder_m) - low;
  return "viewBox=\"" + coordinates({low.x(), low.y() + size.y()}) + " " + coordinates({size.x(), -size.y()}) + "\"";
}

std::string path_of(const Geometry& geometry) {
  if (const auto* face = std::get_if<Segment>(&geometry))
    return "M" + coordinates(face->begin) + "L" + coordinates(face->end);
  const auto* column = std::get_if<Circle>(&geometry);
  if (!column) return "";
  const std::string r = std::to_string(std::lround(100 * column->radius_m)),
                    across = std::to_string(2 * std::lround(100 * column->radius_m));
  return "M" + coordinates(column->center - Point(column->radius_m, 0)) + "a" + r + " " + r + " 0 1 0 " + across +
         " 0a" + r + " " + r + " 0 1 0 -" + across + " 0";
}

template <class Keep>
std::string polyline(const ChallengeRun& run, const std::string& style, const Keep& point_of) {
  constexpr std::size_t kEvery = 5;
  std::string path;
  for (std::size_t k = 0; k < run.moments.size(); k += kEvery)
    path += (path.empty() ? "M" : "L") + coordinates(point_of(run.moments[k]));
  return "<path class=\"" + style + "\" d=\"" + path + "\"/>";
}

std::string way_of(const ChallengeRun& run) {
  return polyline(run, std::string("way ") + name_of(outcome_of(run)),
                  [](const JudgedMoment& moment) { return moment.truth.position(); });
}

std::string dot(const Point& at, double radius_m, const std::string& style) {
  return fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", style, std::lround(100 * at.x()),
                     std::lround(-100 * at.y()), std::lround(100 * radius_m));
}

/// Thinned: every half metre.
std::string wrong_claims(const ChallengeRun& run) {
  constexpr double kEvery_m = 0.5, kDot_m = 0.25;
  std::string dots;
  std::optional<Point> last;
  for (const JudgedMoment& moment : run.moments) {
    const Point at = moment.estimate.position();
    if (!moment.localized() || moment.right() || (last && (at - *last).norm() < kEvery_m)) continue;
    dots += dot(at, kDot_m, "claim");
    last = at;
  }
  return dots;
}

std::string picture(const BuildingRuns& building, const std::string& content) {
  return "<svg class=\"building\" " + view_box_of(*building.map) + "><use href=\"#" + building.building.id + "\"/>" +
         content + "</svg>";
}

}  // namespace

std::string outline_symbol(const BuildingRuns& building) {
  std::string walls, unseen;
  for (const MapFeature& feature : building.map->features())
    (feature.sensor.empty() ? unseen : walls) += path_of(feature.geometry);
  // The class is on what is referred to: a style that names an element around it does not reach where it is used.
  return "<g id=\"" + building.building.id + "\" class=\"building\"><path class=\"unseen\" d=\"" + unseen +
         "\"/><path class=\"wall\" d=\"" + walls + "\"/></g>\n";
}

std::string ways_picture(const BuildingRuns& building, const std::string& contender) {
  std::vector<const ChallengeRun*> runs;
  for (const ChallengeRun& run : building.runs)
    if (run.contender == contender) runs.push_back(&run);
  std::stable_sort(runs.begin(), runs.end(),
                   [](const ChallengeRun* a, const ChallengeRun* b) { return outcome_of(*a) < outcome_of(*b); });
  std::string content;
  for (const ChallengeRun* run : runs) content += way_of(*run) + wrong_claims(*run);
  return picture(building, content);
}

std::string run_picture(const BuildingRuns& building, const ChallengeRun& run) {
  constexpr double kDot_m = 0.4;
  if (run.moments.empty()) return picture(building, "");
  std::string content = way_of(run) + wrong_claims(run) + dot(run.moments.front().truth.position(), kDot_m, "start");
  if (const JudgedMoment& last = run.moments.back(); last.has_pose)
    content += dot(last.estimate.position(), kDot_m, "believed");
  return picture(building, content);
}

}  // namespace opal::experiments
