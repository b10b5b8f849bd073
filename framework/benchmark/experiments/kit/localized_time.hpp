#pragma once

#include <optional>

namespace opal::experiments {

/// For how long poses were called localized, right and wrong ones. An answer holds until the next one, but not for
/// longer than a second: then it is silence. The last one holds no time.
class LocalizedTime {
 public:
  /// @param stamp_s  increasing from 0 on; an older one adds nothing.
  void add(double stamp_s, bool is_localized, bool is_right);

  double right_s = 0;                       ///< a right pose was called localized, in all
  double wrong_s = 0;                       ///< a wrong pose was
  double longest_wrong_s = 0;               ///< the longest time of it without a break
  std::optional<double> wrong_from_s = {};  ///< the first of it

 private:
  /// The newest answer has held so long.
  void hold(double time_s);

  double before_s_ = 0, stretch_s_ = 0;
  bool is_localized_ = false, is_right_ = false;
};

}  // namespace opal::experiments
