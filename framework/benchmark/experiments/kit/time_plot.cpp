#include "benchmark/experiments/kit/time_plot.hpp"

#include "benchmark/experiments/kit/table.hpp"
#include "report/html_text.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace opal::experiments {
namespace {

constexpr double kWidth = 460, kLeft = 46, kRow = 74, kGap = 16;

/// One curve over time on a logarithmic axis.
struct Curve {
  const char* name;
  double low, high;                            ///< decades that are shown at least
  std::function<double(const Moment&)> value;  ///< below `low`: drawn there; NaN: a gap
  const char* colour;
};

class Plot {
 public:
  explicit Plot(std::span<const Moment> moments) : moments_(moments), end_s_(std::max(1.0, moments.back().time_s)) {}

  void add(Curve curve) {
    for (const Moment& moment : moments_)
      if (std::isfinite(curve.value(moment)))
        while (curve.value(moment) > curve.high) curve.high *= 10;
    grid(curve);
    draw(curve);
    top_ += kRow + kGap;
  }
  void add_status_bar();
  std::string svg() const {
    return "<svg xmlns='http://www.w3.org/2000/svg' role='img' viewBox='0 0 " + number(kLeft + kWidth + 12, 0) + ' ' +
           number(top_ + 18, 0) + "' font-family='sans-serif' font-size='10'>\n" + svg_ + "</svg>\n";
  }

 private:
  double x(double time_s) const { return kLeft + kWidth * time_s / end_s_; }
  double y(const Curve& curve, double value) const {
    const double share = std::log10(std::max(value, curve.low) / curve.low) / std::log10(curve.high / curve.low);
    return top_ + kRow * (1 - share);
  }
  void line(double x1, double y1, double x2, double y2, const char* style) {
    svg_ += "<line x1='" + number(x1, 1) + "' y1='" + number(y1, 1) + "' x2='" + number(x2, 1) + "' y2='" +
            number(y2, 1) + "' " + style + "/>\n";
  }
  void text(double px, double py, const std::string& words, const char* anchor) {
    svg_ += "<text x='" + number(px, 1) + "' y='" + number(py, 1) + "' text-anchor='" + anchor + "' fill='#444'>" +
            html_text(words) + "</text>\n";
  }
  void grid(const Curve& curve) {
    for (double value = curve.low; value <= curve.high * 1.001; value *= 10) {
      line(kLeft, y(curve, value), kLeft + kWidth, y(curve, value), "stroke='#e2e2e2'");
      text(kLeft - 4, y(curve, value) + 3, value < 1 ? number(value, value < 0.1 ? 2 : 1) : number(value, 0), "end");
    }
    text(kLeft + 4, top_ - 3, curve.name, "start");
  }
  void draw(const Curve& curve) {
    std::string points;
    const auto end = [&] {
      if (!points.empty())
        svg_ += "<polyline fill='none' stroke-width='1.3' stroke='" + std::string(curve.colour) + "' points='" +
                points + "'/>\n";
      points.clear();
    };
    for (const Moment& moment : moments_) {
      if (!std::isfinite(curve.value(moment)))
        end();
      else
        points += number(x(moment.time_s), 1) + ',' + number(y(curve, curve.value(moment)), 1) + ' ';
    }
    end();
  }

  std::span<const Moment> moments_;
  double end_s_, top_ = 16;
  std::string svg_;
};

const char* colour_of(const Moment& moment) {
  if (moment.localized()) return moment.right() ? "#2e9e5b" : "#d01c1c";
  return moment.has_pose ? "#e8c04a" : "#d5d5d5";
}

void Plot::add_status_bar() {
  constexpr double kBar = 9;
  for (std::size_t k = 0; k < moments_.size();) {
    std::size_t end = k;
    while (end < moments_.size() && colour_of(moments_[end]) == colour_of(moments_[k])) ++end;
    const double from = x(moments_[k].time_s), to = end < moments_.size() ? x(moments_[end].time_s) : kLeft + kWidth;
    svg_ += "<rect x='" + number(from, 1) + "' y='" + number(top_ - 8, 1) + "' width='" +
            number(std::max(0.5, to - from), 1) + "' height='" + number(kBar, 0) + "' fill='" + colour_of(moments_[k]) +
            "'/>\n";
    k = end;
  }
  const double step = end_s_ > 300 ? 100 : end_s_ > 100 ? 50 : 10;
  for (double time_s = 0; time_s <= end_s_ + 1e-6; time_s += step)
    text(x(time_s), top_ + 13, number(time_s, 0) + (time_s > 0 ? "" : " s"), "middle");
}

}  // namespace

std::string time_plot(std::span<const Moment> moments) {
  if (moments.empty()) return "";
  Plot plot(moments);
  plot.add({"error of the best hypothesis m", 0.01, 10,
            [](const Moment& m) { return m.has_pose ? m.error_m() : std::nan(""); }, "#0072b2"});
  plot.add(
      {"hypotheses", 1, 10, [](const Moment& m) { return m.hypotheses > 0 ? m.hypotheses : std::nan(""); }, "#d55e00"});
  if (std::any_of(moments.begin(), moments.end(), [](const Moment& m) { return m.cpu_ms > 0; }))
    plot.add({"CPU ms per update", 0.1, 10, [](const Moment& m) { return m.cpu_ms > 0 ? m.cpu_ms : std::nan(""); },
              "#5b3a9e"});
  plot.add_status_bar();
  return plot.svg();
}

}  // namespace opal::experiments
