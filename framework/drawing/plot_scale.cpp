#include "drawing/plot_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal {
namespace {

/// The step of 1, 2 or 5 times a power of ten that divides a range into about so many parts.
double round_step(double range, int count) {
  const double step = range / std::max(1, count);
  const double power = std::pow(10, std::floor(std::log10(step)));
  const double rest = step / power;
  return power * (rest < std::sqrt(2.0) ? 1 : rest < std::sqrt(10.0) ? 2 : rest < std::sqrt(50.0) ? 5 : 10);
}

std::vector<double> linear_ticks(double low, double high, int count) {
  std::vector<double> ticks;
  const double step = round_step(high - low, count);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) ticks.push_back(k * step);
  return ticks;
}

/// These digits times each power of ten between the ends.
std::vector<double> decade_ticks(double low, double high, std::initializer_list<int> digits) {
  std::vector<double> ticks;
  for (double power = std::floor(std::log10(low)); power <= std::log10(high); ++power)
    for (const int digit : digits)
      if (const double tick = digit * std::pow(10, power); tick >= low && tick <= high) ticks.push_back(tick);
  return ticks;
}

}  // namespace

PlotScale::PlotScale(const PlotAxis& axis, std::span<const double> values, double from_px, double to_px)
    : logarithmic_(axis.logarithmic), from_px_(from_px), to_px_(to_px) {
  constexpr double kRoom = 0.06;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto show = [&](double value) {
    if (!std::isfinite(value) || (logarithmic_ && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  std::for_each(values.begin(), values.end(), show);
  if (axis.from) show(*axis.from);
  if (axis.to) show(*axis.to);
  if (low > high) low = logarithmic_ ? 1 : 0, high = logarithmic_ ? 10 : 1;
  const double factor = logarithmic_ ? std::pow(std::max(high / low, 1.1), kRoom) : 1;
  const double room = kRoom * (high > low ? high - low : low != 0 ? std::abs(low) : 1);
  low_ = axis.from && low == *axis.from ? low : logarithmic_ ? low / factor : low - room;
  high_ = axis.to && high == *axis.to ? high : logarithmic_ ? high * factor : high + room;
}

double PlotScale::px(double value) const {
  const double inside = std::clamp(value, low_, high_);
  const double share =
      logarithmic_ ? std::log(inside / low_) / std::log(high_ / low_) : (inside - low_) / (high_ - low_);
  return from_px_ + share * (to_px_ - from_px_);
}

std::vector<double> PlotScale::ticks(int count) const {
  if (!logarithmic_) return linear_ticks(low_, high_, count);
  const std::vector<double> some = decade_ticks(low_, high_, {1, 2, 5});
  if (some.size() >= 3 && some.size() <= static_cast<std::size_t>(count) + 1) return some;
  const std::vector<double> decades = decade_ticks(low_, high_, {1});
  return decades.size() >= 3 ? decades : linear_ticks(low_, high_, count);
}

std::string title_of(const PlotAxis& axis) {
  return axis.unit.empty() ? axis.name : axis.name + " [" + axis.unit + "]";
}

std::string tick_text(double value) { return fmt::format("{:.4g}", std::abs(value) < 1e-12 ? 0.0 : value); }

}  // namespace opal
