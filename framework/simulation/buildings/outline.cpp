#include "simulation/buildings/outline.hpp"

namespace opal::simulation {
namespace {

constexpr std::array<std::array<int, 2>, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Walks along the sides of cells, floor on the left.
class Walk {
 public:
  explicit Walk(const PlanGrid& grid) : grid_(grid), columns_(grid.columns() + 1) {
    sides_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(grid.rows() + 1));
    for (int row = 0; row <= grid.rows(); ++row)
      for (int column = 0; column < columns_; ++column)
        for (int quarter = 0; quarter < 4; ++quarter)
          if (is_floor(left_of({column, row, quarter})) && !is_floor(right_of({column, row, quarter})))
            sides(column, row) |= 1 << quarter;
  }

  std::vector<Outline> run() {
    std::vector<Outline> outlines;
    for (int row = 0; row <= grid_.rows(); ++row)
      for (int column = 0; column < columns_; ++column)
        for (int quarter = 0; quarter < 4; ++quarter)
          if (sides(column, row) & 1 << quarter) outlines.push_back(outline_from({column, row, quarter}));
    return outlines;
  }

 private:
  /// A side of a cell: where it begins, and its direction.
  struct Side {
    int column, row, quarter;
  };
  using Place = std::array<int, 2>;

  static Place left_of(const Side& s) {
    return {s.column - (s.quarter == 1 || s.quarter == 2), s.row - (s.quarter == 2 || s.quarter == 3)};
  }
  static Place right_of(const Side& s) {
    return {s.column - (s.quarter == 2 || s.quarter == 3), s.row - (s.quarter == 0 || s.quarter == 3)};
  }
  bool is_floor(const Place& p) const { return grid_.is_floor(p[0], p[1]); }
  int& sides(int column, int row) {
    return sides_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  Outline outline_from(const Side& start) {
    std::vector<Side> way{start};
    for (Side side = after(start); !is_same(side, start); side = after(side)) way.push_back(side);
    for (const Side& side : way) sides(side.column, side.row) &= ~(1 << side.quarter);
    return joined(way);
  }

  /// Left first: where two solids touch at a corner, the way stays with its own floor.
  Side after(const Side& side) {
    const auto [dx, dy] = kSteps[static_cast<std::size_t>(side.quarter)];
    const Side next{side.column + dx, side.row + dy, side.quarter};
    for (const int turn : {1, 0})
      if (const int quarter = (side.quarter + turn) % 4; sides(next.column, next.row) & 1 << quarter)
        return {next.column, next.row, quarter};
    return {next.column, next.row, (side.quarter + 3) % 4};
  }

  static bool is_same(const Side& a, const Side& b) {
    return a.column == b.column && a.row == b.row && a.quarter == b.quarter;
  }

  OutlineFace face_of(const Side& s) const {
    const Place floor = left_of(s), other = right_of(s);
    const PlanGrid::Cell& behind = grid_.at(other[0], other[1]);
    OutlineFace face;
    face.begin = {grid_.x(s.column), grid_.y(s.row)};
    face.end = {grid_.x(s.column + kSteps[static_cast<std::size_t>(s.quarter)][0]),
                grid_.y(s.row + kSteps[static_cast<std::size_t>(s.quarter)][1])};
    face.quarter = s.quarter;
    face.thing = behind.thing;
    face.space = grid_.at(floor[0], floor[1]).space;
    face.is_glass = behind.ground == FloorPlan::Ground::outdoors;
    return face;
  }

  static bool is_one_face(const OutlineFace& a, const OutlineFace& b) {
    return a.quarter == b.quarter && a.thing == b.thing && a.is_glass == b.is_glass;
  }

  Outline joined(const std::vector<Side>& way) const {
    Outline faces;
    for (const Side& side : way) {
      const OutlineFace next = face_of(side);
      if (!faces.empty() && is_one_face(faces.back(), next))
        extend(faces.back(), next);
      else
        faces.push_back(next);
    }
    if (faces.size() > 1 && is_one_face(faces.back(), faces.front())) {
      extend(faces.back(), faces.front());
      faces.front() = faces.back();
      faces.pop_back();
    }
    return faces;
  }

  static void extend(OutlineFace& face, const OutlineFace& next) {
    face.end = next.end;
    if (face.space == FloorPlan::kNoSpace) face.space = next.space;
  }

  const PlanGrid& grid_;
  int columns_;
  std::vector<int> sides_;  // for each crossing of lines, a bit for each direction in which a side leaves it
};

}  // namespace

std::vector<Outline> outlines_of(const PlanGrid& grid) { return Walk(grid).run(); }

}  // namespace opal::simulation
