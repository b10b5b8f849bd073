#pragma once

#include "import_kit/plan_boxes.hpp"

#include <optional>
#include <vector>

namespace opal {

/// What is massive in a plan, as regions that may overlap.
class PlanMaterial {
 public:
  /// Why a place counts as massive, as bits.
  enum Reason : unsigned { none = 0, outline = 1, pair = 2 };

  /// @param rings  closed lines; inside each other: holes (even-odd rule).
  void add(std::vector<std::vector<Point>> rings, Reason reason, int element = -1);
  void add(const Circle& disc, int element);

  /// After the last region, before the first question.
  void finish();
  /// All reasons why `p` is massive, leaving out the regions of one element.
  unsigned at(const Point& p, int except_element = -1) const;

 private:
  struct Region {
    std::vector<std::vector<Point>> rings;
    Circle disc;  ///< if there are no rings
    Reason reason = outline;
    int element = -1;

    bool contains(const Point& p) const;
  };

  std::vector<Region> regions_;
  std::vector<PlanBoxes::Box> boxes_;
  std::optional<PlanBoxes> index_;
};

}  // namespace opal
