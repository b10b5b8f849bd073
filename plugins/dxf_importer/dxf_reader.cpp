#include "boundary_loop.hpp"
#include "dxf_curves.hpp"
#include "dxf_drawing.hpp"
#include "dxf_record_check.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <sstream>

namespace opal::dxf_importer {
namespace {

constexpr double kDegree_rad = radians(1);
constexpr int kClosed = 1, kFitted = 2 | 4, kThreeDimensionalMesh = 16 | 64, kFrameVertex = 16;
constexpr int kExternalBlock = 4 | 8;

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

int flags_of(const DxfRecord& record) { return std::atoi(record.text(70, "0").c_str()); }

/// dxflib gets each entity for itself, so that what it passes over, or stumbles over, is known by name.
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
  if (listener.has_curves) trouble = "its boundary has elliptic arcs or splines";
  if (auto* loops = std::get_if<DxfFill>(&listener.shape)) close_loops(listener.edges, *loops);
  return std::move(listener.shape);
}

/// Entities of planes that face down are mirrored: x of their own coordinates runs the other way.
void apply_extrusion(const DxfRecord& record, DxfEntity& entity) {
  const Point across(record.real(210, 0), record.real(220, 0));
  const double up = record.real(230, 1);
  if (across.norm() > 1e-6 * std::abs(up)) entity.trouble = "its plane is tilted against the plan";
  if (up >= 0 || record.type == "LINE" || is_curve(record.type)) return;
  const auto mirror = [](Point& p) { p.x() = -p.x(); };
  const auto mirror_all = [&](std::vector<DxfVertex>& vertices) {
    for (DxfVertex& v : vertices) {
      mirror(v.position);
      v.bulge = -v.bulge;
    }
  };
  if (auto* p = std::get_if<DxfPath>(&entity.shape)) mirror_all(p->vertices);
  if (auto* c = std::get_if<Circle>(&entity.shape)) mirror(c->center);
  if (auto* f = std::get_if<DxfFill>(&entity.shape))
    for (auto& loop : f->loops) mirror_all(loop);
  if (auto* a = std::get_if<DxfArc>(&entity.shape)) {
    mirror(a->circle.center);
    a->from_rad = std::numbers::pi - a->from_rad - a->sweep_rad;
  }
  if (auto* i = std::get_if<DxfInsert>(&entity.shape)) {
    mirror(i->position);
    i->rotation_rad = -i->rotation_rad;
    i->scale.x() = -i->scale.x();
    i->spacing.x() = -i->spacing.x();
  }
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), scan_(scan_dxf(path)) {}

  DxfDrawing run() {
    drawing_.insunits = scan_.insunits;
    drawing_.layers = scan_.layers;
    drawing_.entities = entities(scan_.entities);
    read_blocks();
    return std::move(drawing_);
  }

 private:
  [[noreturn]] void fail(int line, const std::string& complaint) const {
    throw MapError(fmt::format("{}:{}: {}", path_, line, complaint));
  }

  void read_blocks() {
    for (auto begin = scan_.blocks.begin(); begin != scan_.blocks.end();) {
      const auto end =
          std::find_if(begin, scan_.blocks.end(), [](const DxfRecord& record) { return record.type == "ENDBLK"; });
      const std::string name = upper_case(begin->text(2));
      if (name.empty()) fail(begin->line, "a block without a name (code 2), expected one");
      DxfBlock block;
      check_real(*begin, 10);
      check_real(*begin, 20);
      block.base = {begin->real(10, 0), begin->real(20, 0)};
      block.is_external = (flags_of(*begin) & kExternalBlock) != 0;
      block.entities = entities({begin + 1, end});
      if (!drawing_.blocks.emplace(name, std::move(block)).second)
        fail(begin->line, "a second block of this name, expected one");
      begin = end + 1;
    }
  }

  void check_real(const DxfRecord& record, int code) const {
    if (!std::isfinite(record.real(code, 0)) || std::abs(record.real(code, 0)) > 1e12)
      fail(record.line, fmt::format("{}: code {} is no number of at most 1e12", record.type, code));
  }

  std::vector<DxfEntity> entities(const std::vector<DxfRecord>& records) {
    std::vector<DxfEntity> entities;
    for (std::size_t k = 0; k < records.size();) {
      DxfEntityRecords entity{records[k], {}};
      ++k;
      const bool has_parts =
          entity.head.type == "POLYLINE" || (entity.head.type == "INSERT" && entity.head.text(66) == "1");
      while (has_parts && k < records.size() && is_part(records[k].type)) {
        entity.parts.push_back(records[k++]);
        if (entity.parts.back().type == "SEQEND") break;
      }
      if (has_parts && (entity.parts.empty() || entity.parts.back().type != "SEQEND"))
        fail(entity.head.line, entity.head.type + " without SEQEND, expected one at its end");
      entities.push_back(read(entity));
    }
    return entities;
  }

  static bool is_part(const std::string& type) { return type == "VERTEX" || type == "ATTRIB" || type == "SEQEND"; }

  DxfEntity read(const DxfEntityRecords& records) {
    const DxfRecord& head = records.head;
    DxfEntity entity{head.type, id_of(head), head.text(8, "0"), head.text(67) == "1", head.text(60) == "1", false, "",
                     "",        {}};
    entity.has_width = head.real(43, 0) > 0 || (head.type == "POLYLINE" && head.real(40, 0) > 0);
    if (!is_understood(head.type)) return entity;
    if (head.type == "POLYLINE" && (flags_of(head) & kThreeDimensionalMesh) != 0) {
      entity.trouble = "a mesh in space";
      return entity;
    }
    try {
      read_shape_of(records, entity);
    } catch (const MapError& error) {
      if (head.type == "INSERT") throw;  // what is in its block may be anything
      entity.damage = error.what();
      entity.shape = std::monostate();
    }
    return entity;
  }

  void read_shape_of(const DxfEntityRecords& records, DxfEntity& entity) const {
    const DxfRecord& head = records.head;
    check_records(path_, records);
    entity.shape = is_curve(head.type) ? read_curve(head, entity.trouble) : read_shape(path_, records, entity.trouble);
    apply_extrusion(head, entity);
    if (!entity.trouble.empty()) entity.shape = std::monostate();
  }

  std::string id_of(const DxfRecord& record) {
    std::string id = record.text(5);
    const bool is_usable = !id.empty() && id.size() <= 16 &&
                           std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
    const std::string place = fmt::format("line-{}", record.line);
    if (!is_usable) id = place;
    if (!ids_.insert(id).second) ids_.insert(id += "-" + place);
    return id;
  }

  const std::string& path_;
  DxfScan scan_;
  DxfDrawing drawing_;
  std::set<std::string> ids_;
};

}  // namespace

std::string upper_case(std::string name) {
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

DxfDrawing read_dxf(const std::string& path) { return Reader(path).run(); }

}  // namespace opal::dxf_importer
