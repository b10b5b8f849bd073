#include "benchmark/verdict_page/plot_scale.hpp"

#include "report/quantity_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace opal::statistics {
namespace {

/// 1, 2 or 5 times a power of ten, so that there are about six steps.
double round_step(double range) {
  const double rough = range / 6, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power) return factor * power;
  return 10 * power;
}

std::vector<double> linear_ticks(double from, double to) {
  const double step = round_step(to - from);
  std::vector<double> ticks;
  for (double i = std::ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; ++i) ticks.push_back(i * step);
  return ticks;
}

std::vector<double> logarithmic_ticks(double from, double to) {
  std::vector<double> ticks;
  for (double power = std::pow(10.0, std::floor(std::log10(from))); power <= to; power *= 10)
    for (const double factor : {1.0, 2.0, 5.0})
      if (factor * power >= from * (1 - 1e-9) && factor * power <= to * (1 + 1e-9)) ticks.push_back(factor * power);
  return ticks;
}

}  // namespace

PlotScale::PlotScale(double from, double to, double from_px, double to_px, bool logarithmic)
    : from_(from), to_(to), from_px_(from_px), to_px_(to_px), logarithmic_(logarithmic) {
  if (from_ < to_) return;
  from_ = logarithmic ? from / 2 : from - 0.5;
  to_ = logarithmic ? to * 2 : to + 0.5;
}

double PlotScale::place_px(double value) const {
  const double v = std::clamp(value, from_, to_);
  const double share = logarithmic_ ? std::log(v / from_) / std::log(to_ / from_) : (v - from_) / (to_ - from_);
  return from_px_ + share * (to_px_ - from_px_);
}

std::vector<double> PlotScale::ticks() const {
  constexpr std::size_t kTooFew = 2;
  if (!logarithmic_) return linear_ticks(from_, to_);
  const std::vector<double> ticks = logarithmic_ticks(from_, to_);
  return ticks.size() < kTooFew ? linear_ticks(from_, to_) : ticks;
}

std::string px(double value) { return fixed_text(value, 1); }

std::string line(double x1, double y1, double x2, double y2, const std::string& kind) {
  return "<line x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) + "\" y2=\"" + px(y2) + "\" class=\"" +
         kind + "\"/>";
}

std::string tick_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", std::abs(value) < 1e-12 ? 0.0 : value);
  return text;
}

}  // namespace opal::statistics
