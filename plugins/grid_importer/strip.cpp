#include "strip.hpp"

#include <algorithm>
#include <cmath>

namespace opal::grid_importer {
namespace {

// Cells beside a face that are noise of the same surface: about two cells of smear behind, and in front, at the
// 0.05 m that SLAM grids have.
constexpr double kExplainedBehind_m = 0.16;
constexpr double kExplainedBefore_m = 0.12;
// Where the face itself has no cells within this many slices, only what is within the line's own tolerance is noise:
// the rest may be a niche.
constexpr int kCoveredReach = 2;
// +-45 degrees: leaves the perpendicular wall at a corner alone.
constexpr int kExplainedSectors = 2;

constexpr double kOpenCost = 0.12;
constexpr double kFrontierCost = 0.05;

// The biweight reaches farther than the tolerance: cells of even smear across the strip must all have a say.
constexpr double kBiweightReach = 1.5;

/// The cells that a line passes within a tolerance, slice by slice.
class SlicedLine {
 public:
  explicit SlicedLine(const Line& line)
      : line_(line), steep_(std::abs(line.tangent.y()) > std::abs(line.tangent.x())) {}

  double slice_length() const { return 1 / std::abs(major(line_.tangent)); }
  CellPoint at(int slice) const { return line_.at((slice - major(line_.through)) / major(line_.tangent)); }
  int slice_of(const CellPoint& p) const { return static_cast<int>(std::lround(major(p))); }

  template <class Visit>
  void visit(int slice, double from_offset, double to_offset, Visit&& visit) const {
    const double middle =
        minor(line_.through) + (slice - major(line_.through)) * minor(line_.tangent) / major(line_.tangent);
    // Going up in a column is going left if the line runs to the right; rows the other way round.
    const double up = steep_ ? -1 / line_.tangent.y() : 1 / line_.tangent.x();
    const double a = middle + from_offset * up;
    const double b = middle + to_offset * up;
    const int last = static_cast<int>(std::floor(std::max(a, b)));
    for (int k = static_cast<int>(std::ceil(std::min(a, b))); k <= last; ++k)
      visit(steep_ ? Cell{k, slice} : Cell{slice, k});
  }

 private:
  double major(const CellPoint& p) const { return steep_ ? p.y() : p.x(); }
  double minor(const CellPoint& p) const { return steep_ ? p.x() : p.y(); }

  const Line& line_;
  bool steep_;
};

/// Gathers support in one direction, until the gap is too long or the reach is over.
class Walk {
 public:
  Walk(const Boundary& boundary, const Line& line, const Strip& strip)
      : boundary_(boundary),
        sliced_(line),
        strip_(strip),
        sector_(DirectionSet::sector_of(line.normal())),
        tangent_(line.tangent),
        max_gap_(strip.gap / sliced_.slice_length() + kGapRounding),
        max_reach_(strip.reach / sliced_.slice_length()) {}

  Support run(int start, int step) const {
    Support support;
    for (int k = 0, last = 0; k <= max_reach_ && k - last <= max_gap_ + 1; ++k) {
      const int slice = start + k * step;
      sliced_.visit(slice, -strip_.tolerance, strip_.tolerance, [&](const Cell& c) {
        if (const int cell = boundary_.at(c); cell >= 0 && supports(boundary_[cell])) support.push_back({cell, slice});
      });
      if (!support.empty() && support.back().slice == slice) last = k;
    }
    return support;
  }

  int start_of(const CellPoint& p) const { return sliced_.slice_of(p); }

 private:
  bool supports(const BoundaryCell& cell) const {
    return cell.visible.contains(sector_) && !cell.explained.contains(sector_) && cell.agreement(tangent_) > 0;
  }

  const Boundary& boundary_;
  SlicedLine sliced_;
  Strip strip_;
  int sector_;
  CellPoint tangent_;
  double max_gap_;
  double max_reach_;
};

/// Calls visit(first, last) for each covered slice: positions [first, last) in the support.
template <class Visit>
void visit_slices(const Support& support, Visit&& visit) {
  for (std::size_t first = 0, last = 0; first < support.size(); first = last) {
    while (last < support.size() && support[last].slice == support[first].slice) ++last;
    visit(first, last);
  }
}

/// What a slice without support costs: beams that went through speak against a wall; free space that ends at the line
/// speaks for one, of which no beam happened to hit this cell.
double slice_cost(const OccupancyGrid& grid, const Line& line, const CellPoint& p, double min_coverage) {
  const Cell cell = cell_at(p);
  const int sector = DirectionSet::sector_of(line.normal());
  if (!is_open(grid, cell, sector)) return min_coverage;
  const bool is_open_behind = is_open(grid, cell, (sector + DirectionSet::kSectors / 2) % DirectionSet::kSectors);
  return is_open_behind ? min_coverage + kOpenCost : std::min(kFrontierCost, min_coverage);
}

double gap_cost(const Boundary& boundary, const Line& line, int before, int after, double min_coverage) {
  const SlicedLine sliced(line);
  double cost = 0;
  for (int slice = before + 1; slice < after; ++slice)
    cost += slice_cost(boundary.grid(), line, sliced.at(slice), min_coverage);
  return cost;
}

CellPoint position(const Boundary& boundary, const Supporter& supporter) {
  return centre_of(boundary[supporter.cell].cell);
}

double biweight(double distance, double tolerance) {
  const double share = distance / (kBiweightReach * tolerance);
  return std::abs(share) < 1 ? std::pow(1 - share * share, 2) : 0;
}

/// The best that the cells of one slice say for a surface along the line, 0 to 1. Distance counts by the parabola
/// 1 - (d / tolerance)^2, which is kinder to cells beside the line than the biweight of the fit.
double agreement(const Boundary& boundary, const Line& line, const Support& support, std::size_t first,
                 std::size_t last, double tolerance) {
  double best = 0;
  for (std::size_t k = first; k < last; ++k) {
    const double share = line.offset(position(boundary, support[k])) / tolerance;
    best = std::max(best, (1 - share * share) * boundary[support[k].cell].agreement(line.tangent));
  }
  return best;
}

}  // namespace

Support gather_support(const Boundary& boundary, const Line& line, const CellPoint& start, const Strip& strip) {
  const Walk walk(boundary, line, strip);
  const int middle = walk.start_of(start);
  Support support = walk.run(middle - 1, -1);
  std::reverse(support.begin(), support.end());
  const Support forward = walk.run(middle, 1);
  support.insert(support.end(), forward.begin(), forward.end());
  return support;
}

BestPart best_part(const Boundary& boundary, const Line& line, const Support& support, double tolerance,
                   double min_coverage) {
  double surplus = 0;
  double best = 0;
  std::size_t begin = 0;
  std::size_t best_begin = 0;
  std::size_t best_end = 0;
  visit_slices(support, [&](std::size_t first, std::size_t last) {
    if (first > 0) surplus -= gap_cost(boundary, line, support[first - 1].slice, support[first].slice, min_coverage);
    if (surplus <= 0) {
      surplus = 0;
      begin = first;
    }
    surplus += agreement(boundary, line, support, first, last, tolerance) - min_coverage;
    if (surplus > best) {
      best = surplus;
      best_begin = begin;
      best_end = last;
    }
  });
  return {Support(support.begin() + static_cast<std::ptrdiff_t>(best_begin),
                  support.begin() + static_cast<std::ptrdiff_t>(best_end)),
          best};
}

LineFit fit_to(const Boundary& boundary, const Support& support, const Line& line, double tolerance) {
  LineFit fit(line.through);
  visit_slices(support, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const CellPoint p = position(boundary, support[k]);
      fit.add(p, biweight(line.offset(p), tolerance) / static_cast<double>(last - first));
    }
  });
  return fit;
}

Face face_of(const Boundary& boundary, const Support& support, const LineFit& fit, const CellPoint& towards,
             double tolerance) {
  const Line line = fit.line(towards);
  double low = line.along(position(boundary, support.front()));
  double high = low;
  for (const Supporter& supporter : support) {
    low = std::min(low, line.along(position(boundary, supporter)));
    high = std::max(high, line.along(position(boundary, supporter)));
  }
  double slices = 0;
  visit_slices(support, [&](std::size_t first, std::size_t last) {
    slices += agreement(boundary, line, support, first, last, tolerance);
  });
  const double covered = std::min(high - low, slices * SlicedLine(line).slice_length());
  return {line.at(low), line.at(high), covered, fit.rms()};
}

double extent_of(const Boundary& boundary, const Support& support, const Line& line) {
  return support.empty() ? 0
                         : std::abs(line.along(position(boundary, support.front())) -
                                    line.along(position(boundary, support.back())));
}

void explain(Boundary& boundary, const Face& face, const Support& support, double tolerance) {
  const Line line = face.line();
  const SlicedLine sliced(line);
  const int sector = DirectionSet::sector_of(line.normal());
  const auto explain_slice = [&](int slice, double behind, double before) {
    sliced.visit(slice, -behind, before, [&](const Cell& c) {
      if (const int cell = boundary.at(c); cell >= 0) boundary[cell].explained.add(sector, kExplainedSectors);
    });
  };
  const int first = std::min(sliced.slice_of(face.begin), sliced.slice_of(face.end));
  const int last = std::max(sliced.slice_of(face.begin), sliced.slice_of(face.end));
  for (int slice = first; slice <= last; ++slice) explain_slice(slice, tolerance, tolerance);
  const double behind = boundary.grid().to_cells(kExplainedBehind_m);
  const double before = boundary.grid().to_cells(kExplainedBefore_m);
  visit_slices(support, [&](std::size_t k, std::size_t) {
    const int from = std::max(first, support[k].slice - kCoveredReach);
    const int to = std::min(last, support[k].slice + kCoveredReach);
    for (int slice = from; slice <= to; ++slice) explain_slice(slice, behind, before);
  });
}

}  // namespace opal::grid_importer
