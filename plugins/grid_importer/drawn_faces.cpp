#include "drawn_faces.hpp"

#include "strip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace opal::grid_importer {
namespace {

// Shorter runs say nothing of whether a grid was drawn.
constexpr double kTellingRun_m = 0.4;
constexpr int kTellingCells = 6;
// Of all cells that free space touches, so many lie in telling runs: of twelve recorded grids 0.00 to 0.03, of drawn
// plans more than 0.5.
constexpr double kDrawnShare = 0.3;
// One cell has no direction, however large it is.
constexpr int kFewestCells = 2;
// Deeper behind or before a gap, another run is no bottom of a niche.
constexpr double kNicheDepth_m = 0.6;

/// A row or column of cells that free space touches from one side.
struct Run {
  Cell first, last;       ///< along the tangent of the face
  int length = 1;         ///< in cells
  bool has_step = false;  ///< goes on one cell beside, at one end
};

/// One of four sides from which cells are seen, and the way along the face: free space is on its left.
struct Side {
  Cell normal, tangent;
};
constexpr std::array<Side, 4> kSides{{{{0, 1}, {1, 0}}, {{0, -1}, {-1, 0}}, {{1, 0}, {0, -1}}, {{-1, 0}, {0, 1}}}};

int along(const Cell& cell, const Cell& direction) { return cell.column * direction.column + cell.row * direction.row; }

class DrawnSide {
 public:
  DrawnSide(const Boundary& boundary, const Side& side) : boundary_(boundary), side_(side) {
    for (const BoundaryCell& cell : boundary.cells()) {
      if (!is_face(cell.cell)) continue;
      ++cells_;
      if (is_face(moved(cell.cell, side.tangent, -1))) continue;
      Run run{cell.cell, cell.cell};
      for (; is_face(moved(run.last, side.tangent)); ++run.length) run.last = moved(run.last, side.tangent);
      const int step = longest_step(run);
      run.has_step = step > 0;
      // A slanted wall goes on one cell beside, in runs of about the same length; a jog is deeper.
      if (2 * step < run.length) runs_.push_back(run);
    }
  }

  long cells() const { return cells_; }

  long cells_in_telling_runs(int least) const {
    long cells = 0;
    for (const Run& run : runs_) cells += run.length >= least && !run.has_step ? run.length : 0;
    return cells;
  }

  /// Runs on one line with a short gap become one, unless a niche is in the gap.
  std::vector<Run> joined(double gap, double depth) const {
    std::vector<Run> sorted = runs_;
    std::sort(sorted.begin(), sorted.end(), [&](const Run& a, const Run& b) {
      return std::pair(line_of(a), begin_of(a)) < std::pair(line_of(b), begin_of(b));
    });
    std::vector<Run> joined;
    for (const Run& run : sorted) {
      const bool goes_on = !joined.empty() && line_of(joined.back()) == line_of(run) &&
                           begin_of(run) - end_of(joined.back()) - 1 <= gap + 2 * kGapRounding &&
                           !has_niche(end_of(joined.back()) + 1, begin_of(run) - 1, line_of(run), depth);
      if (goes_on) {
        joined.back().length = begin_of(run) + run.length - begin_of(joined.back());
        joined.back().last = run.last;
      } else {
        joined.push_back(run);
      }
    }
    return joined;
  }

 private:
  /// Occupied, seen, and with free space right beside it.
  bool is_face(const Cell& cell) const {
    const int number = boundary_.at(cell);
    return number >= 0 && boundary_[number].explained.empty() &&
           boundary_.grid().at(moved(cell, side_.normal)) == Occupancy::free;
  }

  /// Cells of a run, on one side of a cell that may be in it.
  int length_from(Cell cell, int step) const {
    int length = 0;
    for (; is_face(cell); cell = moved(cell, side_.tangent, step)) ++length;
    return length;
  }

  /// Cells of the longer run that goes on one cell beside this one, at either end.
  int longest_step(const Run& run) const {
    int longest = 0;
    for (const int beside : {-1, 1}) {
      const Cell before = moved(moved(run.first, side_.tangent, -1), side_.normal, beside);
      const Cell after = moved(moved(run.last, side_.tangent), side_.normal, beside);
      longest = std::max({longest, length_from(before, -1), length_from(after, 1)});
    }
    return longest;
  }

  int line_of(const Run& run) const { return along(run.first, side_.normal); }
  int begin_of(const Run& run) const { return along(run.first, side_.tangent); }
  int end_of(const Run& run) const { return begin_of(run) + run.length - 1; }

  bool has_niche(int from, int to, int line, double depth) const {
    return std::any_of(runs_.begin(), runs_.end(), [&](const Run& run) {
      const int off = std::abs(line_of(run) - line);
      return off > 0 && off <= depth && begin_of(run) <= to && end_of(run) >= from;
    });
  }

  const Boundary& boundary_;
  Side side_;
  long cells_ = 0;
  std::vector<Run> runs_;
};

Face face_along(const Run& run) {
  Face face{centre_of(run.first), centre_of(run.last), 0, 0};
  face.covered = face.length();
  return face;
}

Support support_of(const Boundary& boundary, const Run& run, const Cell& tangent) {
  Support support;
  for (int k = 0; k < run.length; ++k) {
    const Cell cell = moved(run.first, tangent, k);
    if (const int number = boundary.at(cell); number >= 0)
      support.push_back({number, tangent.row == 0 ? cell.column : cell.row});
  }
  return support;
}

}  // namespace

GridKind kind_of(const Boundary& boundary) {
  const int telling =
      std::max(kTellingCells, static_cast<int>(std::ceil(boundary.grid().to_cells(kTellingRun_m) - kGapRounding)));
  long all = 0, straight = 0;
  for (const Side& side : kSides) {
    const DrawnSide drawn(boundary, side);
    all += drawn.cells();
    straight += drawn.cells_in_telling_runs(telling);
  }
  const bool is_drawn = all > 0 && static_cast<double>(straight) >= kDrawnShare * static_cast<double>(all);
  return is_drawn ? GridKind::drawn : GridKind::recorded;
}

std::vector<Face> find_drawn_faces(Boundary& boundary, const VectorizerLimits& limits) {
  const auto cells = [&](double length_m) { return boundary.grid().to_cells(length_m) - kGapRounding; };
  const double least = std::max<double>(kFewestCells, cells(limits.min_face_m));
  std::vector<std::pair<Run, Cell>> found;
  for (const Side& side : kSides)
    for (const Run& run : DrawnSide(boundary, side).joined(cells(limits.bridge_gap_m), cells(kNicheDepth_m)))
      if (run.length >= least) found.emplace_back(run, side.tangent);
  std::vector<Face> faces;
  for (const auto& [run, tangent] : found) {
    faces.push_back(face_along(run));
    explain(boundary, faces.back(), support_of(boundary, run, tangent),
            boundary.grid().to_cells(limits.line_tolerance_m));
  }
  return faces;
}

}  // namespace opal::grid_importer
