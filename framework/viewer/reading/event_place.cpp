#include "viewer/reading/event_place.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <cmath>

namespace opal {
namespace {

constexpr std::size_t kLongestName = 1000, kLongestSentence = 4000, kLongestShown = 60;
constexpr double kLargestAngle_rad = 1e6, kLargestStamp_s = 1e12, kLargest_nat = 1e9;

/// The first bytes of a text, without a torn UTF-8 character at the end.
std::string cut(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) --bytes;
  return text.substr(0, bytes) + "...";
}

std::string shown(const Event& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  return cut(value.dump(-1, ' ', false, Event::error_handler_t::replace), kLongestShown);
}

bool is_integer(const Event& value, int least) {
  constexpr int kLargest = 2'000'000'000;
  return value.is_number_integer() && value.get<double>() >= least && value.get<double>() <= kLargest;
}

std::string plain(double number) { return fmt::format("{:.6g}", number); }

}  // namespace

EventPlace EventPlace::step(const Step& next, const Event& value) const {
  EventPlace place = *this;
  if (place.depth_ < kDeepest) place.steps_[place.depth_++] = next;
  place.value_ = &value;
  return place;
}

void EventPlace::fail(const std::string& expected) const {
  std::string pointer;
  for (std::size_t k = 0; k < depth_; ++k)
    pointer += '/' + (steps_[k].name ? escape_pointer_step(steps_[k].name) : std::to_string(steps_[k].index));
  throw EventError((pointer.empty() ? "(root)" : pointer) + ": " + shown(*value_) + ", expected " + expected);
}

void EventPlace::require_object() const {
  if (!value_->is_object()) fail("an object");
}

void EventPlace::require_array(std::size_t size, const char* expected) const {
  if (!value_->is_array() || value_->size() != size) fail(expected);
}

EventPlace EventPlace::member(const char* name) const {
  require_object();
  const auto found = value_->find(name);
  if (found == value_->end()) fail(std::string("a member '") + name + "'");
  return step({name, 0}, *found);
}

std::optional<EventPlace> EventPlace::find(const char* name) const {
  require_object();
  const auto found = value_->find(name);
  if (found == value_->end() || found->is_null()) return std::nullopt;
  return step({name, 0}, *found);
}

std::size_t EventPlace::elements() const {
  if (!value_->is_array()) fail("an array");
  return value_->size();
}

EventPlace EventPlace::element(std::size_t index) const {
  if (index >= elements()) fail(fmt::format("at least {} elements", index + 1));
  return step({nullptr, index}, (*value_)[index]);
}

double EventPlace::number(double least, double most) const {
  const double number = value_->is_number() ? value_->get<double>() : std::nan("");
  if (!(number >= least && number <= most)) fail("a number in [" + plain(least) + ", " + plain(most) + "]");
  return number;
}

double EventPlace::coordinate() const { return number(-kFarthest_m, kFarthest_m); }
double EventPlace::stamp_s() const { return number(-kLargestStamp_s, kLargestStamp_s); }
double EventPlace::probability() const { return is_null() ? 0 : number(0, 1); }
double EventPlace::nat() const { return is_null() ? kWorst_nat : number(-kLargest_nat, kLargest_nat); }

int EventPlace::count() const {
  if (!is_integer(*value_, 0)) fail("an integer in [0, 2e9]");
  return value_->get<int>();
}

int EventPlace::number_of_id() const {
  if (!is_integer(*value_, -1)) fail("an id, an integer in [-1, 2e9]");
  return value_->get<int>();
}

bool EventPlace::flag() const {
  if (!value_->is_boolean()) fail("true or false");
  return value_->get<bool>();
}

const std::string& EventPlace::name() const {
  if (!value_->is_string()) fail("a string");
  const auto& text = value_->get_ref<const std::string&>();
  if (text.size() > kLongestName) fail(fmt::format("a name of at most {} bytes", kLongestName));
  return text;
}

std::string EventPlace::sentence() const {
  if (!value_->is_string()) fail("a string");
  return cut(value_->get_ref<const std::string&>(), kLongestSentence);
}

double EventPlace::coordinate(std::size_t index) const {
  const Event& value = (*value_)[index];
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  return std::abs(number) <= kFarthest_m ? number : element(index).coordinate();
}

double EventPlace::angle(std::size_t index) const {
  const Event& value = (*value_)[index];
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  return std::abs(number) <= kLargestAngle_rad ? number : element(index).number(-kLargestAngle_rad, kLargestAngle_rad);
}

Pose2 EventPlace::pose() const {
  require_array(3, "[x, y, heading]");
  return {coordinate(0), coordinate(1), angle(2)};
}

std::vector<Point> EventPlace::points() const {
  if (elements() % 2 != 0) fail("[x, y, x, y, ...], an even number of coordinates");
  std::vector<Point> points(elements() / 2);
  for (std::size_t k = 0; k < points.size(); ++k) points[k] = {coordinate(2 * k), coordinate(2 * k + 1)};
  return points;
}

Geometry EventPlace::geometry() const {
  if (const auto p = find("point")) {
    p->require_array(2, "[x, y]");
    return Point(p->coordinate(0), p->coordinate(1));
  }
  if (const auto p = find("oriented_point")) {
    p->require_array(4, "[x, y, heading, opening]");
    return OrientedPoint{{p->coordinate(0), p->coordinate(1)}, wrap_angle(p->angle(2)), p->angle(3)};
  }
  if (const auto s = find("segment")) {
    s->require_array(4, "[begin x, begin y, end x, end y]");
    return Segment{{s->coordinate(0), s->coordinate(1)}, {s->coordinate(2), s->coordinate(3)}};
  }
  if (const auto c = find("circle")) {
    c->require_array(3, "[x, y, radius]");
    return Circle{{c->coordinate(0), c->coordinate(1)}, c->element(2).number(0, kFarthest_m)};
  }
  fail("a member 'point', 'oriented_point', 'segment' or 'circle'");
}

}  // namespace opal
