#include "viewer/moment.hpp"

#include "viewer/quantity_text.hpp"

#include <opal/error.hpp>

#include <charconv>
#include <cmath>
#include <optional>

namespace opal {
namespace {

std::optional<double> number_of(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// Decides frame by frame; remembers which time lines there were, for the message if it is none of them.
class MomentSearch {
 public:
  explicit MomentSearch(const Moment& moment) : moment_(moment) {}

  enum class Verdict { skip, take, stop };
  Verdict judge(const RunFrame& frame) {
    if (frame.starts) {
      if (in_time_line_ && !takes_all()) return Verdict::stop;
      in_time_line_ = moment_.query.empty() || *frame.starts == moment_.query;
      names_ += (names_.empty() ? "" : ", ") + *frame.starts;
    }
    if (!in_time_line_) return Verdict::skip;
    if (is_after(frame)) return Verdict::stop;
    taken_ = true;
    return Verdict::take;
  }

  void require_found(const std::string& out) const {
    if (taken_) return;
    if (!in_time_line_)
      throw EventError(out + ": time line '" + moment_.query + "' was asked for, the run has: " + names_);
    throw EventError(out + ": the time line has nothing as early as " + fixed_text(moment_.seconds, 3) + " s");
  }

 private:
  /// The last time line is known only at the end of the stream.
  bool takes_all() const { return moment_.clock == Moment::Clock::end && moment_.query.empty(); }
  bool is_after(const RunFrame& frame) const {
    constexpr double kWritten_s = 5e-4;  // people copy times with three decimals
    if (moment_.clock == Moment::Clock::end) return false;
    const double at = moment_.clock == Moment::Clock::stamp ? frame.stamp_s : frame.time_s;
    return at > moment_.seconds + kWritten_s;
  }

  const Moment& moment_;
  bool in_time_line_ = false, taken_ = false;
  std::string names_;
};

}  // namespace

Moment parse_moment(const std::string& text, const std::string& query) {
  const std::string stamp = "stamp:";
  if (text == "end") return {Moment::Clock::end, 0, query};
  const bool is_stamp = text.starts_with(stamp);
  const auto seconds = number_of(std::string_view(text).substr(is_stamp ? stamp.size() : 0));
  if (!seconds)
    throw Error("moment '" + text + "', expected seconds since the start (12.5), a stamp of the log (stamp:1626.25) or 'end'");
  return {is_stamp ? Moment::Clock::stamp : Moment::Clock::since_start, *seconds, query};
}

RunReading read_until(const std::string& out, const Moment& moment,
                      const std::function<void(const RunHeader&, const RunFrame&)>& take) {
  MomentSearch search(moment);
  RunReading reading = read_run(out, [&](const RunHeader& header, RunFrame&& frame) {
    const auto verdict = search.judge(frame);
    if (verdict == MomentSearch::Verdict::take) take(header, frame);
    return verdict != MomentSearch::Verdict::stop;
  });
  search.require_found(out);
  return reading;
}

}  // namespace opal
