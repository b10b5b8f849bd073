#pragma once

#include <opal/common/geometry.hpp>
#include <opal/common/id.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace opal {

/// Puts one record together: JSON without spaces, numbers as short as their precision allows. Commas set
/// themselves.
class RecordText {
 public:
  RecordText& open(char bracket);  ///< '[' or '{'
  RecordText& close(char bracket);
  RecordText& key(std::string_view name);
  RecordText& text(std::string_view value);
  RecordText& boolean(bool value);
  RecordText& integer(long long value);
  template <class Kind>
  RecordText& id(Id<Kind> id) {  ///< -1: of none
    return integer(id.number());
  }
  /// Rounded to this many decimals.
  RecordText& number(double value, int decimals);
  RecordText& pose(const Pose2& pose, int decimals);  ///< three elements
  /// [x, y, dx, dy, ...] in steps of `unit_m`; only every `stride`-th point.
  RecordText& points(std::span<const Point> points, double unit_m, int stride);
  RecordText& integers(std::span<const int> values);
  template <class Kind>
  RecordText& ids(const std::vector<Id<Kind>>& ids) {
    open('[');
    for (const Id<Kind> each : ids) id(each);
    return close(']');
  }

  std::string take() { return std::move(record_); }

 private:
  void separate();
  std::string record_;
};

/// The number as a record says it: what a reader of `number(value, decimals)` gets.
double rounded(double value, int decimals);

}  // namespace opal
