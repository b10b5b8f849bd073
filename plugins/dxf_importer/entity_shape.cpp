#include "entity_shape.hpp"

#include "boundary_loop.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace opal::dxf_importer {
namespace {

constexpr double kDegree_rad = radians(1);
// Of a face: how much more level than upright it is, or the other way round.
constexpr double kLevel = 100;
constexpr int kClosed = 1, kFitted = 2 | 4, kFrameVertex = 16;

/// What dxflib says about one entity.
class EntityListener final : public DL_CreationAdapter {
 public:
  int entities = 0;
  DxfShape shape;

  void addLine(const DL_LineData& d) override { take(DxfPath{{{{d.x1, d.y1}, 0}, {{d.x2, d.y2}, 0}}, false}); }
  void addCircle(const DL_CircleData& d) override { take(Circle{{d.cx, d.cy}, d.radius}); }
  void addArc(const DL_ArcData& d) override {
    const double sweep_deg = std::fmod(std::fmod(d.angle2 - d.angle1, 360) + 360, 360);
    take(DxfArc{{{d.cx, d.cy}, d.radius}, d.angle1 * kDegree_rad, (sweep_deg > 0 ? sweep_deg : 360) * kDegree_rad});
  }
  void addPolyline(const DL_PolylineData& d) override { take(DxfPath{{}, (d.flags & kClosed) != 0}); }
  void addVertex(const DL_VertexData& d) override {
    if (auto* path = std::get_if<DxfPath>(&shape)) path->vertices.push_back({{d.x, d.y}, d.bulge});
  }
  void addInsert(const DL_InsertData& d) override {
    take(DxfInsert{d.name, {d.ipx, d.ipy}, {d.sx, d.sy}, d.angle * kDegree_rad, d.cols, d.rows, {d.colSp, d.rowSp}});
  }
  void addSolid(const DL_SolidData& d) override { take_filled(d); }
  void addTrace(const DL_TraceData& d) override { take_filled(d); }
  void add3dFace(const DL_3dFaceData& d) override { take(shape_of_face(d)); }
  void addHatch(const DL_HatchData&) override { take(DxfFill{}); }
  /// Before the loop of a polyline, dxflib names an empty one.
  void addHatchLoop(const DL_HatchLoopData& d) override {
    if (d.numEdges <= 0) return;
    fill().loops.emplace_back();
    edges.emplace_back();
  }
  void addHatchEdge(const DL_HatchEdgeData& d) override {
    if (fill().loops.empty()) addHatchLoop(DL_HatchLoopData(1));
    std::vector<DxfVertex>& loop = fill().loops.back();
    if (d.type == 0)
      for (const std::vector<double>& v : d.vertices) add_boundary_vertex(v, loop);
    else if (d.type == 1)
      edges.back().push_back({{d.x1, d.y1}, {d.x2, d.y2}, 0});
    else if (d.type == 2)
      edges.back().push_back(arc_edge(d));
    else
      has_curves = true;
  }
  std::vector<std::vector<BoundaryEdge>> edges;  ///< of each loop of a hatch that is made of edges
  bool has_curves = false;
  bool is_incomplete = false;

 private:
  void add_boundary_vertex(const std::vector<double>& v, std::vector<DxfVertex>& loop) {
    if (v.size() < 2)
      is_incomplete = true;
    else
      loop.push_back({{v[0], v[1]}, v.size() > 2 ? v[2] : 0});
  }
  void take(DxfShape taken) {
    ++entities;
    shape = std::move(taken);
  }
  DxfFill& fill() {
    if (!std::holds_alternative<DxfFill>(shape)) shape = DxfFill{};
    return std::get<DxfFill>(shape);
  }
  /// The third and fourth corner stand crosswise.
  void take_filled(const DL_SolidData& d) {
    take(DxfFill{{{{{d.x[0], d.y[0]}, 0}, {{d.x[1], d.y[1]}, 0}, {{d.x[3], d.y[3]}, 0}, {{d.x[2], d.y[2]}, 0}}}});
  }
  /// A level face is filled, an upright one is the line on which it stands. Of a tilted one nothing is made.
  static DxfShape shape_of_face(const DL_3dFaceData& d) {
    std::vector<Eigen::Vector3d> corners;
    for (int k = 0; k < 4; ++k) corners.emplace_back(d.x[k], d.y[k], d.z[k]);
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]) +
                                   (corners[2] - corners[0]).cross(corners[3] - corners[0]);
    const double level = std::abs(normal.z()), upright = normal.head<2>().norm();
    if (level > kLevel * upright) {
      std::vector<DxfVertex> loop;
      for (const Eigen::Vector3d& corner : corners) loop.push_back({corner.head<2>(), 0});
      return DxfFill{{std::move(loop)}};
    }
    if (upright < kLevel * level) return std::monostate();
    const Point along = left_of(normal.head<2>().normalized());
    const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return along.dot(a.head<2>()) < along.dot(b.head<2>());
    };
    const auto [first, last] = std::minmax_element(corners.begin(), corners.end(), nearer);
    return DxfPath{{{first->head<2>(), 0}, {last->head<2>(), 0}}, false};
  }
  /// dxflib gives angles in radians; of a clockwise arc they are mirrored.
  static BoundaryEdge arc_edge(const DL_HatchEdgeData& d) {
    const double sign = d.ccw ? 1 : -1;
    const double sweep_rad =
        std::fmod(std::fmod(d.angle2 - d.angle1, 2 * std::numbers::pi) + 2 * std::numbers::pi, 2 * std::numbers::pi);
    const Point center(d.cx, d.cy);
    return {center + d.radius * unit_vector(sign * d.angle1), center + d.radius * unit_vector(sign * d.angle2),
            sign * std::tan((sweep_rad > 0 ? sweep_rad : 1e-9) / 4)};
  }
};

void write(std::ostream& text, const DxfRecord& record) {
  text << "0\n" << record.type << '\n';
  for (const DxfPair& pair : record.pairs)
    if (pair.code == 2 || (pair.code >= 8 && pair.code < 300))
      text << pair.code << '\n' << pair.value.substr(0, 500) << '\n';
}

}  // namespace

int flags_of(const DxfRecord& record) { return std::atoi(record.text(70, "0").c_str()); }

DxfShape read_shape(const std::string& path, const DxfEntityRecords& entity, std::string& trouble) {
  std::stringstream text;
  text << "0\nSECTION\n2\nENTITIES\n";
  write(text, entity.head);
  const bool is_fitted = (flags_of(entity.head) & kFitted) != 0;
  for (const DxfRecord& part : entity.parts)
    if (part.type == "SEQEND" || (part.type == "VERTEX" && !(is_fitted && flags_of(part) & kFrameVertex)))
      write(text, part);
  text << "0\nENDSEC\n0\nEOF\n";
  EntityListener listener;
  DL_Dxf().in(text, &listener);
  if (listener.entities != 1)
    throw MapError(fmt::format("{}:{}: {} cannot be read by dxflib ({} entities), expected one", path, entity.head.line,
                               entity.head.type, listener.entities));
  const auto* fill = std::get_if<DxfFill>(&listener.shape);
  const bool lacks_loops = entity.head.type == "HATCH" && fill != nullptr &&
                           static_cast<int>(fill->loops.size()) != std::atoi(entity.head.text(91).c_str());
  if (listener.is_incomplete || lacks_loops)
    throw MapError(
        fmt::format("{}:{}: HATCH: its boundary is incomplete, expected {} loops (code 91) of vertices with x and y",
                    path, entity.head.line, entity.head.text(91)));
  if (entity.head.type == "3DFACE" && std::holds_alternative<std::monostate>(listener.shape))
    trouble = "it is a tilted face";
  if (listener.has_curves) trouble = "its boundary has elliptic arcs or splines";
  if (auto* loops = std::get_if<DxfFill>(&listener.shape)) close_loops(listener.edges, *loops);
  return std::move(listener.shape);
}

}  // namespace opal::dxf_importer
