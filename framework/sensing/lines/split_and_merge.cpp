#include "sensing/lines/split_and_merge.hpp"

#include <optional>

namespace opal {
namespace {

constexpr int kMinPiecePoints = 3;

class Pieces {
 public:
  Pieces(const ScanChains& chains, const LineExtractionOptions& options) : chains_(chains), options_(options) {}

  std::vector<Run> found() {
    for (const Run& chain : chains_.chains) split(chain);
    for (Run& piece : pieces_) piece = trimmed(piece, fit_line(chains_, {&piece, 1}, options_.noise));
    return std::move(pieces_);
  }

 private:
  const Point& position(int hit) const { return chains_.hits[hit].position; }
  double tolerance_m(double range_m) const { return line_tolerance_m(options_, range_m); }
  std::optional<int> split_point(const Run& run) const;
  void split(const Run& chain);
  void add_piece(const Run& piece, int chain_first_piece);
  bool one_line(const Run& a, const Run& b) const;
  bool follows(const LineFit& fit, const Run& run) const;
  Run trimmed(Run run, const LineFit& fit) const;

  const ScanChains& chains_;
  const LineExtractionOptions& options_;
  std::vector<Run> pieces_;
};

/// The piece after which the run is cut: the hit farthest from the chord, in units of the tolerance. Of its
/// two gaps the wider one is cut. Empty if all hits are near.
std::optional<int> Pieces::split_point(const Run& run) const {
  const Point& a = position(run.first);
  const Point chord = position(run.last) - a;
  const double length = chord.norm();
  double worst = 1;
  int at = -1;
  for (int i = run.first + 1; i < run.last; ++i) {
    const Point p = position(i) - a;
    const double distance = length > 1e-9 ? std::abs(cross(chord, p)) / length : p.norm();
    const double ratio = distance / tolerance_m(chains_.hits[i].range_m);
    if (ratio > worst) worst = ratio, at = i;
  }
  if (at < 0) return std::nullopt;
  const double before = (position(at) - position(at - 1)).squaredNorm();
  const double after = (position(at + 1) - position(at)).squaredNorm();
  return before > after ? at - 1 : at;
}

void Pieces::split(const Run& chain) {
  const int chain_first_piece = static_cast<int>(pieces_.size());
  std::vector<Run> open{chain};
  while (!open.empty()) {
    const Run run = open.back();
    open.pop_back();
    if (run.size() < kMinPiecePoints) continue;
    if (const std::optional<int> cut = split_point(run)) {
      open.push_back({*cut + 1, run.last});
      open.push_back({run.first, *cut});
    } else {
      add_piece(run, chain_first_piece);
    }
  }
}

/// Appends a piece, merged with those before it in its chain as long as one line explains them.
void Pieces::add_piece(const Run& piece, int chain_first_piece) {
  Run merged = piece;
  while (static_cast<int>(pieces_.size()) > chain_first_piece && pieces_.back().last + 1 == merged.first &&
         one_line(pieces_.back(), merged)) {
    merged.first = pieces_.back().first;
    pieces_.pop_back();
  }
  pieces_.push_back(merged);
}

bool Pieces::one_line(const Run& a, const Run& b) const {
  const Run both{a.first, b.last};
  const LineFit fit = fit_line(chains_, {&both, 1}, options_.noise);
  return follows(fit, a) && follows(fit, b);
}

/// Whether the points of a run scatter around a line within 0.6 of the tolerance (rms).
bool Pieces::follows(const LineFit& fit, const Run& run) const {
  const Point normal = left_of(fit.direction);
  double squares = 0;
  for (int i = run.first; i <= run.last; ++i) {
    const double ratio = normal.dot(position(i) - fit.centroid) / tolerance_m(chains_.hits[i].range_m);
    squares += ratio * ratio;
  }
  return squares <= 0.36 * run.size();
}

/// Without end points that lie off the line: those of a corner that the split gave to the wrong side.
Run Pieces::trimmed(Run run, const LineFit& fit) const {
  const Point normal = left_of(fit.direction);
  const auto off = [&](int i) {
    return std::abs(normal.dot(position(i) - fit.centroid)) > 0.8 * tolerance_m(chains_.hits[i].range_m);
  };
  while (run.size() > kMinPiecePoints && off(run.first)) ++run.first;
  while (run.size() > kMinPiecePoints && off(run.last)) --run.last;
  return run;
}

}  // namespace

std::vector<Run> split_and_merged(const ScanChains& chains, const LineExtractionOptions& options) {
  return Pieces(chains, options).found();
}

}  // namespace opal
