#include <opal/import_kit/wide_walls.hpp>

#include <cmath>
#include <map>
#include <utility>

namespace opal {
namespace {

// Ends that are nearer are one place.
constexpr double kSameWidePlace_m = 0.01;
// Pieces that turn back on each other have no corner: their faces would meet far away.
constexpr double kSharpestWide = 0.3;

struct WideEnd {
  std::size_t piece = 0;
  Point away = Point::Zero();  ///< from the end into the piece
};

using WidePlace = std::pair<long long, long long>;

WidePlace wide_place_of(const Point& p) {
  return {std::llround(p.x() / kSameWidePlace_m), std::llround(p.y() / kSameWidePlace_m)};
}

using EndsByPlace = std::map<WidePlace, std::vector<WideEnd>>;

EndsByPlace wide_ends_of(const std::vector<WidePiece>& pieces) {
  EndsByPlace ends;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Segment& middle = pieces[k].middle;
    ends[wide_place_of(middle.begin)].push_back({k, middle.direction()});
    ends[wide_place_of(middle.end)].push_back({k, -middle.direction()});
  }
  return ends;
}

/// From the middle of an end to the corner on the left of someone who comes out of the piece there.
/// @param out  direction of the piece, out of the end
Point to_corner(const Point& out, double half_m, bool on_left, std::size_t piece, const std::vector<WideEnd>& here) {
  const double side = on_left ? 1 : -1;
  const Point square = side * half_m * left_of(out);
  if (here.size() < 2) return square;
  if (here.size() > 2) return square + half_m * out;
  const Point on = (here.front().piece == piece ? here.back() : here.front()).away;  // how the other piece goes on
  if (1 + out.dot(on) < kSharpestWide) return square + half_m * out;
  return side * half_m * (left_of(out) + left_of(on)) / (1 + out.dot(on));
}

}  // namespace

std::vector<std::vector<Point>> widened(const std::vector<WidePiece>& pieces) {
  const EndsByPlace ends = wide_ends_of(pieces);
  std::vector<std::vector<Point>> outlines;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Segment& middle = pieces[k].middle;
    const double half_m = pieces[k].width_m / 2;
    const Point along = middle.direction();
    const auto corner = [&](const Point& end, const Point& out, bool on_left) -> Point {
      return end + to_corner(out, half_m, on_left, k, ends.at(wide_place_of(end)));
    };
    outlines.push_back({corner(middle.begin, -along, true), corner(middle.end, along, false),
                        corner(middle.end, along, true), corner(middle.begin, -along, false)});
  }
  return outlines;
}

}  // namespace opal
