#include "simulation/buildings/kinds.hpp"

#include <algorithm>
#include <cmath>

namespace opal::simulation {
namespace {

constexpr int kCorridorRecess_cm = 15, kCorridorDoor_cm = 100;
constexpr int kCornerClear_cm = 60;  // of a block, without niches
constexpr int kDeepest_cm = 80;      // niche
constexpr int kShallowest_cm = 150;  // dead end
constexpr int kStep_cm = 300;        // a niche or door at most every 3 m

/// What may be cut into a block's face, per step of its length.
struct Cut {
  enum class Kind { none, niche, door } kind = Kind::none;
  int offset = 0, width = 0, depth = 0;
};

class Corridors {
 public:
  Corridors(Variation& vary, double size_m2) : vary_(vary), corridor_(vary.between(170, 280)) {
    const int block_x = vary.between(600, 1500), block_y = vary.between(600, 1200);
    const double area = 1e4 * size_m2;
    const int columns = std::max(2, static_cast<int>(std::lround(std::sqrt(1.5 * area) / (block_x + corridor_))));
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(area / 1.5) / (block_y + corridor_))));
    xs_ = lines(block_x, columns);
    ys_ = lines(block_y, rows);
    usual_ = drawn_cut();
    building_.module = block_x + corridor_;
  }

  PlannedBuilding run() {
    for (std::size_t k = 0; k < ys_.size(); k += 2) building_.plan.room({xs_.front(), ys_[k], xs_.back(), ys_[k + 1]});
    for (std::size_t k = 0; k < xs_.size(); k += 2) building_.plan.room({xs_[k], ys_.front(), xs_[k + 1], ys_.back()});
    for (std::size_t row = 1; row + 1 < ys_.size(); row += 2) {
      for (std::size_t column = 2; column + 2 < xs_.size(); column += 2)
        add_dead_end({xs_[column], ys_[row], xs_[column + 1], ys_[row + 1]});
      for (std::size_t column = 1; column + 1 < xs_.size(); column += 2)
        add_block({xs_[column], ys_[row], xs_[column + 1], ys_[row + 1]});
    }
    add_outer_walls();
    return std::move(building_);
  }

 private:
  /// Both sides of each corridor; blocks lie between.
  std::vector<int> lines(int block, int blocks) {
    std::vector<int> all{0, vary_.length(corridor_, 170, 320)};
    for (int k = 0; k < blocks; ++k) {
      all.push_back(all.back() + vary_.length(block, rounded_to_grid(block * 2 / 3), rounded_to_grid(block * 4 / 3)));
      all.push_back(all.back() + vary_.length(corridor_, 170, 320));
    }
    return all;
  }

  Cut drawn_cut() {
    Cut cut;
    cut.kind = static_cast<Cut::Kind>(vary_.between(0, 10) / 5);
    cut.width = cut.kind == Cut::Kind::door ? kCorridorDoor_cm : vary_.between(110, 220);
    cut.offset = vary_.between(20, kStep_cm - 20 - cut.width);
    cut.depth = vary_.between(25, kDeepest_cm);
    return cut;
  }

  void add_block(const Box& block) {
    for (int x = block.left + kCornerClear_cm; x + kStep_cm + kCornerClear_cm <= block.right; x += kStep_cm) {
      add_cut(x, [&](int from, int to, int near, int far) {
        return Box{from, block.bottom + near, to, block.bottom + far};
      });
      add_cut(x, [&](int from, int to, int near, int far) { return Box{from, block.top - far, to, block.top - near}; });
    }
    for (int y = block.bottom + kCornerClear_cm; y + kStep_cm + kCornerClear_cm <= block.top; y += kStep_cm) {
      if (!is_closed(block.left, y))
        add_cut(y, [&](int from, int to, int near, int far) {
          return Box{block.left + near, from, block.left + far, to};
        });
      if (!is_closed(block.right, y))
        add_cut(y, [&](int from, int to, int near, int far) {
          return Box{block.right - far, from, block.right - near, to};
        });
    }
  }

  /// Whether the corridor beside a block's face at x is closed somewhere along the step that begins at y.
  bool is_closed(int x, int y) const {
    return std::any_of(dead_ends_.begin(), dead_ends_.end(), [&](const Box& closed) {
      return (closed.left == x || closed.right == x) && closed.bottom < y + kStep_cm && y < closed.top;
    });
  }

  /// Opposite the blocks; glass where blocks have doors.
  void add_outer_walls() {
    const int width = xs_.back(), height = ys_.back();
    // clang-format off
    for (std::size_t column = 1; column + 1 < xs_.size(); column += 2)
      for (int x = xs_[column] + kCornerClear_cm; x + kStep_cm + kCornerClear_cm <= xs_[column + 1]; x += kStep_cm) {
        add_cut(x, [](int from, int to, int near, int far) { return Box{from, -far, to, -near}; }, true);
        add_cut(x, [&](int from, int to, int near, int far) { return Box{from, height + near, to, height + far}; }, true);
      }
    for (std::size_t row = 1; row + 1 < ys_.size(); row += 2)
      for (int y = ys_[row] + kCornerClear_cm; y + kStep_cm + kCornerClear_cm <= ys_[row + 1]; y += kStep_cm) {
        add_cut(y, [](int from, int to, int near, int far) { return Box{-far, from, -near, to}; }, true);
        add_cut(y, [&](int from, int to, int near, int far) { return Box{width + near, from, width + far, to}; }, true);
      }
    // clang-format on
  }

  template <class BoxBehind>
  void add_cut(int begin, const BoxBehind& behind, bool is_facade = false) {
    const Cut cut = vary_.is_usual() ? usual_ : drawn_cut();
    const int from = begin + cut.offset, to = from + cut.width;
    if (cut.kind == Cut::Kind::niche) building_.plan.open(behind(from, to, 0, cut.depth));
    if (cut.kind != Cut::Kind::door) return;
    if (is_facade) return building_.plan.facade_glass(behind(from, to, 0, kCorridorRecess_cm));
    building_.plan.open(behind(from, to, 0, kCorridorRecess_cm));
    building_.plan.thing(behind(from, to, kCorridorRecess_cm, kCorridorRecess_cm + 5), "opal:Door");
  }

  /// Closes a corridor along y between two crossings, in part or all of it; those along x stay open, so nothing is cut
  /// off.
  void add_dead_end(const Box& corridor) {
    const bool is_there = vary_.yes(false, 0.3), is_south = vary_.chance(0.5);
    int length = vary_.between(rounded_to_grid(corridor.height() / 3), corridor.height());
    if (!is_there) return;
    if (corridor.height() - length < kShallowest_cm) length = corridor.height();
    Box closed = corridor;
    (is_south ? closed.top : closed.bottom) = is_south ? corridor.bottom + length : corridor.top - length;
    building_.plan.wall(closed);
    dead_ends_.push_back(closed);
  }

  Variation& vary_;
  PlannedBuilding building_;
  int corridor_;
  std::vector<int> xs_, ys_;
  Cut usual_;
  std::vector<Box> dead_ends_;
};

}  // namespace

PlannedBuilding plan_corridor(Variation& vary, double size_m2) { return Corridors(vary, size_m2).run(); }

}  // namespace opal::simulation
