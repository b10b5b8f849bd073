#include "viewer/words/moment.hpp"

#include "report/quantity_text.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>

#include <cmath>
#include <optional>

namespace opal {
namespace {

std::optional<double> number_of(std::string_view text) {
  const auto number = parse_number<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
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
    if (frame.starts) first_s_ = time_of(frame);
    newest_s_ = time_of(frame);
    if (is_after(frame)) return Verdict::stop;
    taken_ = true;
    return Verdict::take;
  }

  void require_found(const std::string& out) const {
    if (names_.empty()) throw EventError(out + ": holds no complete update, expected one to look at");
    if (!first_s_) throw EventError(out + ": time line '" + moment_.query + "' was asked for, the run has: " + names_);
    const bool too_late = moment_.clock != Moment::Clock::end && moment_.seconds > newest_s_ + kWritten_s;
    if (!taken_ || too_late)
      throw EventError(out + ": moment " + fixed_text(moment_.seconds, 3) + " s, expected one " +
                       (too_late ? "in [" + fixed_text(*first_s_, 3) + ", " + fixed_text(newest_s_, 3) + "]"
                                 : "from " + fixed_text(*first_s_, 3) + " s on"));
  }

 private:
  /// The last time line is known only at the end of the stream.
  bool takes_all() const { return moment_.clock == Moment::Clock::end && moment_.query.empty(); }
  bool is_after(const RunFrame& frame) const {
    return moment_.clock != Moment::Clock::end && time_of(frame) > moment_.seconds + kWritten_s;
  }
  double time_of(const RunFrame& frame) const {
    return moment_.clock == Moment::Clock::stamp ? frame.stamp_s : frame.time_s;
  }

  static constexpr double kWritten_s = 5e-4;  ///< people copy times with three decimals

  const Moment& moment_;
  bool in_time_line_ = false, taken_ = false;
  std::optional<double> first_s_;  ///< of the time line; absent: there is none
  double newest_s_ = 0;            ///< of the newest frame that was met in it
  std::string names_;
};

}  // namespace

Moment parse_moment(const std::string& text, const std::string& query) {
  const std::string stamp = "stamp:";
  if (text == "end") return {Moment::Clock::end, 0, query};
  const bool is_stamp = text.starts_with(stamp);
  const auto seconds = number_of(std::string_view(text).substr(is_stamp ? stamp.size() : 0));
  if (!seconds)
    throw Error("moment '" + text +
                "', expected seconds since the start (12.5), a stamp of the log (stamp:1626.25) or 'end'");
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
