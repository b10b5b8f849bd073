#pragma once

#include "dxf_scan.hpp"

#include <opal/common/geometry.hpp>
#include <opal/import_kit/b_spline.hpp>

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace opal::dxf_importer {

/// A vertex, and how the line goes on from there: bulge is the tangent of a quarter of the arc's angle,
/// counter-clockwise if positive; 0: straight.
struct DxfVertex {
  Point position = Point::Zero();
  double bulge = 0;
};

struct DxfPath {
  std::vector<DxfVertex> vertices;
  bool closed = false;
  double width = 0;  ///< with which it is drawn; 0: as thin as can be, or not everywhere the same
};

struct DxfArc {
  Circle circle;
  double from_rad = 0;
  double sweep_rad = 0;  ///< in (0, 2 pi], counter-clockwise
};

/// center + cos(u) major + sin(u) minor, for u from `from_rad` on.
struct DxfEllipse {
  Point center = Point::Zero(), major = Point::Zero(), minor = Point::Zero();
  double from_rad = 0;
  double sweep_rad = 0;  ///< in (0, 2 pi]
};

/// Side by side, as an MLINE has them.
struct DxfLines {
  std::vector<DxfPath> lines;
};

/// Closed lines, filled between them.
struct DxfFill {
  std::vector<std::vector<DxfVertex>> loops;
  int open_loops = 0;  ///< that were left out, since their edges do not meet
};

/// A block put at a place, or at all places of an array of `columns` by `rows`.
struct DxfInsert {
  std::string block;
  Point position = Point::Zero();
  Point scale{1, 1};
  double rotation_rad = 0;
  int columns = 1;
  int rows = 1;
  Point spacing = Point::Zero();  ///< between columns and rows, before the rotation
};

/// Nothing, if the importer does not understand entities of this type.
using DxfShape =
    std::variant<std::monostate, DxfPath, Circle, DxfArc, DxfEllipse, BSpline, DxfLines, DxfFill, DxfInsert>;

/// An entity in the coordinates and units of its block or drawing.
struct DxfEntity {
  std::string type;  ///< "LWPOLYLINE"
  std::string id;    ///< its handle; "line-1204" if it has none; "2F-line-1204" if another has the same
  std::string layer;
  bool is_in_paper_space = false;
  bool is_hidden = false;  ///< as those states of a dynamic block that are not chosen
  /// A whole message, if its record is damaged: a map must not be made of it. An INSERT still names its block.
  std::string damage;
  std::string trouble;  ///< why there is no shape, if there should be one
  DxfShape shape;
};

struct DxfBlock {
  Point base = Point::Zero();
  bool is_external = false;  ///< stands for another file
  std::vector<DxfEntity> entities;
  /// A whole message, if nobody knows what it draws: its base is no place, or another block of its name is different.
  std::string damage;
};

struct DxfDrawing {
  std::optional<int> insunits;
  std::map<std::string, DxfLayer> layers;
  std::map<std::string, DxfBlock> blocks;  ///< by name in upper case
  std::vector<DxfEntity> entities;
  std::vector<std::string> repeated_blocks;  ///< "CHAIR (line 184)": the first block of this name counts
  int clips = 0;                             ///< that show a part of a block; the block is here whole
  std::vector<std::string> clipped = {};     ///< ids of the INSERTs that they belong to, and names of their blocks
  int lines_after_end = 0;
  bool lacks_end = false;  ///< the record EOF is missing, after the whole section ENTITIES
};

/// @throws MapError "PATH:LINE: what was found, what was expected".
DxfDrawing read_dxf(const std::string& path);

}  // namespace opal::dxf_importer
