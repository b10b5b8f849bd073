#include "benchmark/experiments/kit/ways_picture.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "report/html_text.hpp"

#include <Eigen/Geometry>

#include <array>

namespace opal::experiments {
namespace {

// Told apart by people who see few colours, too (Okabe and Ito 2008), darker for white paper.
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#56b4e9", "#5b3a9e",
                              "#8c1d18", "#3f7d20", "#7a7a7a", "#004d66", "#c2185b", "#6d4c1f", "#00897b"};

std::string at(const Point& p) { return number(p.x(), 2) + ',' + number(-p.y(), 2); }

std::string line_of(const std::vector<Point>& points, const std::string& style) {
  if (points.size() < 2) return "";
  std::string text = "<polyline fill='none' " + style + " points='";
  for (const Point& p : points) text += at(p) + ' ';
  return text + "'/>\n";
}

std::string disc(const Point& p, double radius_m, const std::string& style) {
  return "<circle cx='" + number(p.x(), 2) + "' cy='" + number(-p.y(), 2) + "' r='" + number(radius_m, 2) + "' " +
         style + "/>\n";
}

std::string building(const SemanticMap& map, Eigen::AlignedBox2d& extent) {
  std::string svg;
  for (const MapFeature& feature : map.features()) {
    if (const auto* segment = std::get_if<Segment>(&feature.geometry)) {
      extent.extend(segment->begin).extend(segment->end);
      svg += line_of({segment->begin, segment->end}, feature.sensor.empty() ? "stroke='#b9c6cf' stroke-width='.06'"
                                                                            : "stroke='#222' stroke-width='.1'");
    } else if (const auto* circle = std::get_if<Circle>(&feature.geometry)) {
      extent.extend(circle->center);
      svg += disc(circle->center, circle->radius_m, "fill='#222'");
    }
  }
  return svg;
}

std::string drawn(const WaysPicture::Way& way, const std::string& colour) {
  std::string svg = line_of(way.estimate, "stroke='#d01c1c' stroke-width='.07' opacity='.8'");
  for (const WaysPicture::Way::Star& star : way.stars) {
    for (const Point& to : star.to) svg += line_of({star.from, to}, "stroke='" + colour + "' stroke-width='.05'");
    svg += disc(star.from, 0.22, "fill='" + colour + "'");
  }
  for (const WaysPicture::Stretch& stretch : way.stretches)
    svg += line_of(stretch.points, "stroke='" + colour + "' stroke-width='.16' stroke-linecap='round'" +
                                       (stretch.solid ? "" : " stroke-dasharray='.02 .32'"));
  if (!way.stretches.empty() && !way.stretches.front().points.empty()) {
    const Point& start = way.stretches.front().points.front();
    svg += disc(start, 0.4, "fill='#fff' stroke='" + colour + "' stroke-width='.14'");
    svg += "<text x='" + number(start.x() + 0.55, 2) + "' y='" + number(-start.y() - 0.3, 2) +
           "' font-size='1.1' font-family='sans-serif' fill='" + colour +
           "' stroke='#fff' stroke-width='.3' paint-order='stroke'>" + html_text(way.name) + "</text>\n";
  }
  for (const Point& mark : way.marks)
    svg += "<path d='M" + at(mark + Point(-0.3, -0.3)) + " L" + at(mark + Point(0.3, 0.3)) + " M" +
           at(mark + Point(-0.3, 0.3)) + " L" + at(mark + Point(0.3, -0.3)) +
           "' stroke='#fff' stroke-width='.3'/><path d='M" + at(mark + Point(-0.3, -0.3)) + " L" +
           at(mark + Point(0.3, 0.3)) + " M" + at(mark + Point(-0.3, 0.3)) + " L" + at(mark + Point(0.3, -0.3)) +
           "' stroke='" + colour + "' stroke-width='.14'/>\n";
  return svg;
}

}  // namespace

std::string svg_of(const SemanticMap& map, const WaysPicture& picture) {
  Eigen::AlignedBox2d extent;
  std::string content = building(map, extent);
  for (const Circle& region : picture.regions)
    content += disc(region.center, region.radius_m, "fill='none' stroke='#d01c1c' stroke-width='.08'");
  for (const Point& goal : picture.goals) content += disc(goal, 0.45, "fill='#1f5fd0'");
  for (std::size_t k = 0; k < picture.ways.size(); ++k)
    content += drawn(picture.ways[k], kColours[k % kColours.size()]);
  const Point low = extent.min() - Point(1, 1), size = extent.sizes() + Point(2, 2);
  return "<svg xmlns='http://www.w3.org/2000/svg' role='img' viewBox='" + number(low.x(), 1) + ' ' +
         number(-low.y() - size.y(), 1) + ' ' + number(size.x(), 1) + ' ' + number(size.y(), 1) + "'>\n" + content +
         "</svg>\n";
}

}  // namespace opal::experiments
