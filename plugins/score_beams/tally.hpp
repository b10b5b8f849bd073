#pragma once

#include <array>
#include <cstddef>

namespace opal::score_beams {

/// Sums for the few dozen things of a kind that one scan meets. Things beyond what there is room for share the last
/// sum.
template <class Thing>
class SumsBy {
 public:
  void add(Thing thing, double amount) { at(thing) += amount; }

  /// 0 for a thing that nothing was added to.
  double of(Thing thing) const {
    for (std::size_t k = 0; k < size_; ++k)
      if (sums_[k].thing == thing) return sums_[k].amount;
    return 0;
  }

  template <class Use>
  void each(Use use) const {
    for (std::size_t k = 0; k < size_; ++k) use(sums_[k].thing, sums_[k].amount);
  }

 private:
  struct Sum {
    Thing thing;
    double amount = 0;
  };

  double& at(Thing thing) {
    if (last_ < size_ && sums_[last_].thing == thing) return sums_[last_].amount;  // neighbouring beams meet one thing
    for (last_ = 0; last_ < size_; ++last_)
      if (sums_[last_].thing == thing) return sums_[last_].amount;
    if (size_ < sums_.size())
      sums_[size_++] = {thing, 0};
    else
      --last_;
    return sums_[last_].amount;
  }

  std::array<Sum, 128> sums_;
  std::size_t size_ = 0, last_ = 0;
};

}  // namespace opal::score_beams
