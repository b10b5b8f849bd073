#include "face_growth.hpp"

#include "strip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

namespace opal::grid_importer {
namespace {

/// Faces are sought from long to short, so that a long wall gets its cells before clutter beside it does. Short
/// faces must be denser: any few cells make some short line.
struct Pass {
  double min_length_m;
  double view_radius_m;  ///< how far around a seed its direction is taken from
  double min_coverage;   ///< least share of the length that has cells
};
constexpr std::array<Pass, 4> kPasses{{{2.0, 0.50, 0.20}, {0.8, 0.50, 0.25}, {0.3, 0.25, 0.35}, {0.0, 0.20, 0.50}}};

constexpr std::size_t kMinCells = 4;
constexpr double kMinWeight = 1;  // of a fit: a line that leaves its cells behind
constexpr double kMinLinearity = 0.6;
// What Pass::min_coverage may fall to where free space ends at the face between its cells.
constexpr double kMinCoveredShare = 0.5;
constexpr int kMaxRefits = 24;  // each refit may double the length: enough for any building
constexpr double kFirstReach_m = 0.6;

// Faces are taken best first; those that lose cells to a better one are grown again in the next round.
constexpr int kMaxRounds = 6;
// A candidate that lost more than this share of its surplus to better faces waits for the next round.
constexpr double kMaxLoss = 0.2;

struct Seed {
  int cell = 0;
  Line line;
  long rank = 0;  ///< straightness and number of cells around, in whole numbers: ties are broken by position
};

/// A face that might be, and what speaks for it.
struct Candidate {
  Seed seed;
  Face face;
  BestPart part;

  /// The surplus, rounded: equal ones must not differ in their last digits by where in the grid they are.
  long rank() const { return std::lround(1e4 * part.surplus); }
};

class Growth {
 public:
  Growth(Boundary& boundary, const VectorizerLimits& limits, const Pass& pass, GridKind kind)
      : boundary_(boundary),
        pass_(pass),
        kind_(kind),
        tolerance_(boundary.grid().to_cells(limits.line_tolerance_m)),
        gap_(boundary.grid().to_cells(limits.bridge_gap_m)),
        min_length_(boundary.grid().to_cells(std::max(pass.min_length_m, limits.min_face_m))) {}

  void run(std::vector<Face>& faces) {
    for (int round = 0; round < kMaxRounds; ++round) {
      const std::size_t before = faces.size();
      for (const Candidate& candidate : best_first()) take(candidate, faces);
      if (faces.size() == before) return;
    }
  }

 private:
  bool is_unexplained(int cell, const Line& line) const {
    const int sector = DirectionSet::sector_of(line.normal());
    return boundary_[cell].visible.contains(sector) && !boundary_[cell].explained.contains(sector);
  }

  /// Of a drawing, one side of a thin wall is often found before the other.
  bool may_grow(const BoundaryCell& cell) const {
    return kind_ == GridKind::drawn ? cell.is_partly_unexplained() : cell.explained.empty();
  }

  LineFit surroundings(const BoundaryCell& cell) const {
    const double radius = boundary_.grid().to_cells(pass_.view_radius_m);
    LineFit fit(centre_of(cell.cell));
    boundary_.visit_near(cell.cell, static_cast<int>(radius), [&](int other) {
      const CellPoint p = centre_of(boundary_[other].cell);
      if (may_grow(boundary_[other]) && (p - centre_of(cell.cell)).squaredNorm() <= radius * radius) fit.add(p);
    });
    return fit;
  }

  void add_seeds(int cell, std::vector<Seed>& seeds) const {
    const LineFit fit = surroundings(boundary_[cell]);
    if (fit.weight() < kMinCells || fit.linearity() < kMinLinearity) return;
    Line line = fit.line(CellPoint(1, 1e-9));
    line.through = centre_of(boundary_[cell].cell);
    const long rank = std::lround(1000 * fit.linearity() * std::min(fit.weight(), 20.0));
    for (const double sign : {1.0, -1.0}) {
      const Line directed{line.through, sign * line.tangent};
      if (is_unexplained(cell, directed)) seeds.push_back({cell, directed, rank});
    }
  }

  std::vector<Seed> seeds() const {
    std::vector<Seed> seeds;
    for (int cell = 0; cell < boundary_.size(); ++cell) add_seeds(cell, seeds);
    std::ranges::stable_sort(seeds, std::greater{}, &Seed::rank);
    return seeds;
  }

  /// Grows seeds, but not those that would give a face that is there already.
  std::vector<Candidate> best_first() const {
    std::vector<DirectionSet> claimed(static_cast<std::size_t>(boundary_.size()));
    std::vector<Candidate> candidates;
    for (const Seed& seed : seeds()) {
      const int sector = DirectionSet::sector_of(seed.line.normal());
      if (claimed[static_cast<std::size_t>(seed.cell)].contains(sector)) continue;
      claimed[static_cast<std::size_t>(seed.cell)].add(sector);
      std::optional<Candidate> candidate = grow(seed);
      if (!candidate) continue;
      const int face_sector = DirectionSet::sector_of(candidate->face.line().normal());
      for (const Supporter& supporter : candidate->part.support)
        claimed[static_cast<std::size_t>(supporter.cell)].add(face_sector, 1);
      candidates.push_back(std::move(*candidate));
    }
    std::ranges::stable_sort(candidates, std::greater{}, &Candidate::rank);
    return candidates;
  }

  void take(const Candidate& candidate, std::vector<Face>& faces) {
    if (!is_unexplained(candidate.seed.cell, candidate.seed.line)) return;
    const std::optional<Candidate> now = grow(candidate.seed);
    if (!now || now->part.surplus < (1 - kMaxLoss) * candidate.part.surplus) return;
    explain(boundary_, now->face, now->part.support, tolerance_);
    faces.push_back(now->face);
  }

  /// Refits the line to what supports it while that reaches farther and farther.
  std::optional<Candidate> grow(const Seed& seed) const {
    const CellPoint start = seed.line.through;
    Line line = seed.line;
    double reach = boundary_.grid().to_cells(kFirstReach_m);
    Support support;
    for (int refit = 0; refit < kMaxRefits; ++refit) {
      Support wider = gather_support(boundary_, line, start, {tolerance_, gap_, reach});
      const bool settled = refit > 2 && wider.size() == support.size();
      support = std::move(wider);
      if (support.size() < kMinCells) return std::nullopt;
      const LineFit fit = fit_to(boundary_, support, line, tolerance_);
      if (fit.weight() < kMinWeight) return std::nullopt;
      line = fit.line(line.tangent);
      if (settled) break;
      reach = std::max(reach, 1.5 * extent_of(boundary_, support, line));
    }
    return candidate(seed, line, best_part(boundary_, line, support, tolerance_, pass_.min_coverage));
  }

  std::optional<Candidate> candidate(const Seed& seed, const Line& line, BestPart part) const {
    if (part.support.size() < kMinCells) return std::nullopt;
    const LineFit fit = fit_to(boundary_, part.support, line, tolerance_);
    if (fit.weight() < kMinWeight) return std::nullopt;
    const Face face = face_of(boundary_, part.support, fit, line.tangent, tolerance_);
    const bool is_covered = face.covered >= kMinCoveredShare * pass_.min_coverage * face.length();
    if (face.length() < min_length_ || !is_covered) return std::nullopt;
    return Candidate{seed, face, std::move(part)};
  }

  Boundary& boundary_;
  Pass pass_;
  GridKind kind_;
  double tolerance_;
  double gap_;
  double min_length_;
};

}  // namespace

std::vector<Face> grow_faces(Boundary& boundary, const VectorizerLimits& limits, GridKind kind) {
  std::vector<Face> faces;
  for (const Pass& pass : kPasses) Growth(boundary, limits, pass, kind).run(faces);
  return faces;
}

}  // namespace opal::grid_importer
