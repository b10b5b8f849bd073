#pragma once

#include <opal/common/geometry.hpp>

#include <sstream>
#include <string>
#include <vector>

/// Writes a DXF drawing as text, entity by entity, as a CAD program would.
class DxfText {
 public:
  /// @param insunits  code of $INSUNITS; -1: not said.
  explicit DxfText(int insunits = 4) : insunits_(insunits) {}

  DxfText& pair(int code, const std::string& value) {
    here() << code << '\n' << value << '\n';
    return *this;
  }
  DxfText& pair(int code, double value) {
    std::ostringstream text;
    text.precision(12);
    text << value;
    return pair(code, text.str());
  }
  DxfText& point(int code, const opal::Point& p) { return pair(code, p.x()).pair(code + 10, p.y()); }

  /// The begin of an entity; its handle counts up from 100 (hexadecimal).
  DxfText& entity(const std::string& type, const std::string& layer) {
    std::ostringstream handle;
    handle << std::hex << std::uppercase << next_handle_++;
    return pair(0, type).pair(5, handle.str()).pair(8, layer);
  }

  DxfText& line(const std::string& layer, const opal::Point& a, const opal::Point& b) {
    return entity("LINE", layer).point(10, a).point(11, b);
  }
  DxfText& circle(const std::string& layer, const opal::Point& centre, double radius) {
    return entity("CIRCLE", layer).point(10, centre).pair(40, radius);
  }
  DxfText& arc(const std::string& layer, const opal::Point& centre, double radius, double from_deg, double to_deg) {
    return entity("ARC", layer).point(10, centre).pair(40, radius).pair(50, from_deg).pair(51, to_deg);
  }
  DxfText& ellipse(const std::string& layer, const opal::Point& centre, const opal::Point& major, double ratio,
                   double from_rad, double to_rad) {
    return entity("ELLIPSE", layer)
        .point(10, centre)
        .point(11, major)
        .pair(40, ratio)
        .pair(41, from_rad)
        .pair(42, to_rad);
  }
  DxfText& spline(const std::string& layer, int degree, const std::vector<double>& knots,
                  const std::vector<opal::Point>& points, const std::vector<double>& weights = {}) {
    entity("SPLINE", layer).pair(70, 8).pair(71, degree).pair(72, static_cast<double>(knots.size()));
    pair(73, static_cast<double>(points.size())).pair(74, 0);
    for (const double knot : knots) pair(40, knot);
    for (const double weight : weights) pair(41, weight);
    for (const opal::Point& p : points) point(10, p);
    return *this;
  }
  /// Straight, from one place to another, with a line on either side of it.
  DxfText& mline(const std::string& layer, const opal::Point& from, const opal::Point& to, double half_width) {
    const opal::Point along = (to - from).normalized(), across = opal::left_of(along);
    entity("MLINE", layer)
        .pair(2, std::string("STANDARD"))
        .pair(40, 1)
        .pair(70, 0)
        .pair(71, 1)
        .pair(72, 2)
        .pair(73, 2)
        .point(10, from);
    for (const opal::Point& p : {from, to}) {
      point(11, p).point(12, along).point(13, across);
      for (const double offset : {half_width, -half_width}) pair(74, 2).pair(41, offset).pair(41, 0).pair(75, 0);
    }
    return *this;
  }
  DxfText& polyline(const std::string& layer, const std::vector<opal::Point>& points, bool closed,
                    const std::vector<double>& bulges = {}) {
    entity("LWPOLYLINE", layer).pair(90, static_cast<double>(points.size())).pair(70, closed ? 1 : 0);
    for (std::size_t k = 0; k < points.size(); ++k) {
      point(10, points[k]);
      if (k < bulges.size()) pair(42, bulges[k]);
    }
    return *this;
  }
  DxfText& box(const std::string& layer, double x0, double y0, double x1, double y1) {
    return polyline(layer, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, true);
  }
  DxfText& insert(const std::string& layer, const std::string& block, const opal::Point& at, double scale_x = 1,
                  double scale_y = 1, double angle_deg = 0) {
    return entity("INSERT", layer).pair(2, block).point(10, at).pair(41, scale_x).pair(42, scale_y).pair(50, angle_deg);
  }

  /// Entities from here to end_block() are in a block.
  DxfText& begin_block(const std::string& name, const opal::Point& base = opal::Point::Zero()) {
    in_block_ = true;
    return pair(0, "BLOCK").pair(8, "0").pair(2, name).pair(70, 0).point(10, base);
  }
  DxfText& end_block() {
    pair(0, "ENDBLK").pair(8, "0");
    in_block_ = false;
    return *this;
  }
  DxfText& layer(const std::string& name, int flags, int colour) {
    layers_ << "0\nLAYER\n2\n" << name << "\n70\n" << flags << "\n62\n" << colour << "\n6\nCONTINUOUS\n";
    return *this;
  }

  std::string text() const {
    std::string all = "999\nwritten by a test\n0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n";
    if (insunits_ >= 0) all += "9\n$INSUNITS\n70\n" + std::to_string(insunits_) + "\n";
    all += "0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n1\n" + layers_.str() + "0\nENDTAB\n0\nENDSEC\n";
    all += "0\nSECTION\n2\nBLOCKS\n" + blocks_.str() + "0\nENDSEC\n";
    return all + "0\nSECTION\n2\nENTITIES\n" + entities_.str() + "0\nENDSEC\n0\nEOF\n";
  }

 private:
  std::ostringstream& here() { return in_block_ ? blocks_ : entities_; }

  int insunits_;
  int next_handle_ = 0x100;
  bool in_block_ = false;
  std::ostringstream layers_, blocks_, entities_;
};

/// A floor of an office in millimetres, 24 m x 12 m: an outline with a corridor and rooms, partitions as pairs of
/// lines, columns as circles, blocks and closed lines, doors as blocks with a swing, glass, furniture and text.
inline std::string small_office() {
  DxfText dxf(4);
  dxf.layer("A-WALL", 0, 7).layer("A-FURN", 0, 7).layer("A-OLD", 1, 7);
  dxf.begin_block("DOOR").line("0", {0, 0}, {0, 900}).arc("0", {0, 0}, 900, 0, 90).end_block();
  dxf.begin_block("COLUMN")
      .circle("0", {0, 0}, 200)
      .line("0", {-140, -140}, {140, 140})
      .line("0", {-140, 140}, {140, -140})
      .end_block();
  dxf.begin_block("DESK").box("A-FURN", 0, 0, 1600, 800).end_block();
  dxf.box("A-WALL", 0, 0, 24000, 12000);
  // Rooms along the south, each with a door of 900 to the corridor at y = 5000 to 7000.
  const auto room = [&](double x0, double x1, double y0, double y1, double door_y, double far_y) {
    const double d0 = x0 + 500, d1 = d0 + 900;
    dxf.polyline("A-WALL",
                 {{d0, far_y},
                  {d0, door_y},
                  {x0, door_y},
                  {x0, door_y == y1 ? y0 : y1},
                  {x1, door_y == y1 ? y0 : y1},
                  {x1, door_y},
                  {d1, door_y},
                  {d1, far_y}},
                 false);
    dxf.insert("A-DOOR", "DOOR", {d0, door_y});
  };
  for (const double x : {300.0, 6300.0, 12300.0, 18300.0})
    room(x, x + (x > 18000 ? 5400 : 5850), 300, 4850, 4850, 5000);
  for (const double x : {300.0, 12300.0}) room(x, x + (x > 12000 ? 11400 : 11850), 7150, 11700, 7150, 7000);
  // The corridor's faces between the doors.
  const auto corridor = [&](double y, const std::vector<double>& doors) {
    double x = 300;
    for (const double d : doors) {
      dxf.line("A-WALL", {x, y}, {d, y});
      x = d + 900;
    }
    dxf.line("A-WALL", {x, y}, {23700, y});
  };
  corridor(5000, {800, 6800, 12800, 18800});
  corridor(7000, {800, 12800});
  dxf.line("A-WALL", {300, 5000}, {300, 7000}).line("A-WALL", {23700, 5000}, {23700, 7000});
  for (const double x : {4000.0, 8000.0, 16000.0, 20000.0}) dxf.insert("S-COLS", "COLUMN", {x, 9500});
  dxf.circle("S-COLS", {2500, 2500}, 150);
  std::vector<opal::Point> drawn;
  for (int k = 0; k < 32; ++k)
    drawn.push_back(opal::Point(9000, 2500) + 180 * opal::unit_vector(k * std::numbers::pi / 16));
  dxf.polyline("S-COLS", drawn, true);
  dxf.box("S-COLS", 14800, 2300, 15200, 2700);
  dxf.line("A-GLAZ", {20000, 300}, {20000, 4850});
  dxf.insert("A-FURN", "DESK", {1000, 1000}).insert("A-FURN", "DESK", {7000, 1000}, 1, 1, 30);
  dxf.entity("TEXT", "A-ANNO").point(10, {1000, 3000}).pair(40, 250).pair(1, std::string("Office 1"));
  dxf.entity("REGION", "A-WALL").pair(70, 1);
  dxf.line("A-OLD", {0, 0}, {24000, 12000});
  return dxf.text();
}
