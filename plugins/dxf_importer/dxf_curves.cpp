#include "dxf_curves.hpp"

#include <cmath>
#include <numbers>

namespace opal::dxf_importer {
namespace {

constexpr int kClosedLines = 2;

Point point_of(const DxfRecord& record, int code) { return {record.real(code, 0), record.real(code + 10, 0)}; }

/// Seen from below, an ellipse runs the other way round.
DxfShape ellipse_of(const DxfRecord& record) {
  DxfEllipse ellipse{point_of(record, 10), point_of(record, 11)};
  const double side = record.real(230, 1) < 0 ? -1 : 1;
  ellipse.minor = side * record.real(40, 1) * Point(-ellipse.major.y(), ellipse.major.x());
  ellipse.from_rad = record.real(41, 0);
  const double sweep_rad =
      std::remainder(record.real(42, 2 * std::numbers::pi) - ellipse.from_rad, 2 * std::numbers::pi);
  ellipse.sweep_rad = sweep_rad > 1e-9 ? sweep_rad : sweep_rad + 2 * std::numbers::pi;
  return ellipse;
}

DxfShape spline_of(const DxfRecord& record, std::string& trouble) {
  BSpline spline;
  spline.degree = static_cast<int>(record.real(71, 0));
  for (const DxfPair& pair : record.pairs) {
    if (pair.code == 40) spline.knots.push_back(pair.real());
    if (pair.code == 41) spline.weights.push_back(pair.real());
    if (pair.code == 10) spline.control_points.emplace_back(pair.real(), 0, 0);
    if (pair.code == 20 && !spline.control_points.empty()) spline.control_points.back().y() = pair.real();
  }
  trouble = spline.control_points.empty() ? "a spline that has points to go through only, and no control points"
                                          : fault_of(spline);
  return spline;
}

/// At each vertex, each line of the style lies so far along the mitre as its first parameter says; the others are
/// dashes.
DxfShape lines_of(const DxfRecord& record, std::string& trouble) {
  const auto parameters = std::ranges::count_if(record.pairs, [](const DxfPair& pair) { return pair.code == 74; });
  const auto lines = static_cast<std::size_t>(std::clamp(record.real(73, 0), 0.0, static_cast<double>(parameters)));
  DxfLines all;
  all.lines.resize(lines, {{}, (static_cast<int>(record.real(71, 0)) & kClosedLines) != 0});
  Point vertex = Point::Zero(), mitre = Point::Zero();
  std::size_t line = lines;
  bool is_first = false;
  for (const DxfPair& pair : record.pairs) {
    if (pair.code == 11) vertex.x() = pair.real(), line = static_cast<std::size_t>(-1);
    if (pair.code == 21) vertex.y() = pair.real();
    if (pair.code == 13) mitre.x() = pair.real();
    if (pair.code == 23) mitre.y() = pair.real();
    if (pair.code == 74) ++line, is_first = true;
    if (pair.code != 41 || !is_first || line >= lines) continue;
    all.lines[line].vertices.push_back({vertex + pair.real() * mitre, 0});
    is_first = false;
  }
  const auto vertices = static_cast<std::size_t>(std::max(0.0, record.real(72, 0)));
  for (const DxfPath& path : all.lines)
    if (path.vertices.size() != vertices || vertices < 2) trouble = "a line of it does not go through all its vertices";
  if (all.lines.empty()) trouble = "it has no lines";
  if (record.real(73, 0) > static_cast<double>(parameters)) trouble = "it has fewer lines than it states";
  if (record.real(230, 1) < 0) trouble = "it is drawn from below";
  return all;
}

}  // namespace

bool is_curve(const std::string& type) { return type == "SPLINE" || type == "ELLIPSE" || type == "MLINE"; }

DxfShape read_curve(const DxfRecord& record, std::string& trouble) {
  if (record.type == "ELLIPSE") return ellipse_of(record);
  return record.type == "SPLINE" ? spline_of(record, trouble) : lines_of(record, trouble);
}

}  // namespace opal::dxf_importer
