#include "viewer/encoding/record_text.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace opal {

double rounded(double value, int decimals) {
  static constexpr std::array kPowers{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
  const double power = kPowers[static_cast<std::size_t>(decimals)];
  const double result = std::round(value * power) / power;
  return result == 0 ? 0 : result;  // no minus zero
}

void RecordText::separate() {
  if (record_.empty()) return;
  const char last = record_.back();
  if (last != '[' && last != '{' && last != ':') record_ += ',';
}

RecordText& RecordText::open(char bracket) {
  separate();
  record_ += bracket;
  return *this;
}

RecordText& RecordText::close(char bracket) {
  record_ += bracket;
  return *this;
}

RecordText& RecordText::key(std::string_view name) {
  text(name);
  record_ += ':';
  return *this;
}

RecordText& RecordText::text(std::string_view value) {
  separate();
  record_ += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return *this;
}

RecordText& RecordText::boolean(bool value) {
  separate();
  record_ += value ? "true" : "false";
  return *this;
}

RecordText& RecordText::integer(long long value) {
  separate();
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  record_.append(digits.data(), end);
  return *this;
}

RecordText& RecordText::number(double value, int decimals) {
  separate();
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), rounded(value, decimals)).ptr;
  record_.append(digits.data(), end);
  return *this;
}

RecordText& RecordText::pose(const Pose2& pose, int decimals) {
  return number(pose.x(), decimals).number(pose.y(), decimals).number(pose.heading_rad(), decimals);
}

RecordText& RecordText::points(std::span<const Point> points, double unit_m, int stride) {
  open('[');
  long long x = 0, y = 0;
  for (std::size_t k = 0; k < points.size(); k += static_cast<std::size_t>(stride)) {
    const long long next_x = std::llround(points[k].x() / unit_m), next_y = std::llround(points[k].y() / unit_m);
    integer(next_x - x).integer(next_y - y);
    x = next_x;
    y = next_y;
  }
  return close(']');
}

RecordText& RecordText::integers(std::span<const int> values) {
  open('[');
  for (const int value : values) integer(value);
  return close(']');
}

}  // namespace opal
