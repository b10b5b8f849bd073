#include <opal/localization/events/event_stream.hpp>

#include <cmath>
#include <ostream>

namespace opal {
namespace {

constexpr double kDecimals = 1e6;
/// Beyond this a double has hardly six decimals left to round.
constexpr double kLargestRounded = 1e9;

void round_numbers(nlohmann::ordered_json& value) {
  if (value.is_structured()) {
    for (auto& member : value) round_numbers(member);
  } else if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::abs(number) < kLargestRounded) value = std::round(number * kDecimals) / kDecimals;
  }
}

}  // namespace

EventSink::~EventSink() = default;

void JsonLinesSink::write(const nlohmann::ordered_json& event) {
  nlohmann::ordered_json line = event;
  round_numbers(line);
  // NaN and infinity, for which JSON has no word, become null.
  out_ << line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace opal
