#include "viewer/serving/live_feed.hpp"

#include "viewer/encoding/page_encoder.hpp"
#include "viewer/reading/event_text.hpp"
#include "viewer/reading/frame_builder.hpp"
#include "viewer/words/explanation.hpp"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>

namespace opal {
namespace {

/// The event as a reader of the event file gets it: numbers rounded, what is no number null.
Event as_written(const nlohmann::ordered_json& event) {
  std::ostringstream line;
  JsonLinesSink(line).write(event);
  return parse_event(line.view());
}

/// How often a window has a record that a reader can begin with.
constexpr std::size_t kBeginnings = 8;

/// Events in, records out.
class RecordMaker {
 public:
  explicit RecordMaker(RecordLog& records) : records_(records) {}

  void take(const nlohmann::ordered_json& event) {
    const std::optional<RunFrame> frame = builder_.add(as_written(event));
    if (!explainer_ && builder_.header()) begin(*builder_.header());
    if (!frame) return;
    explainer_->take(*frame);
    if (records_.window().is_bounded())
      append_to_window(*frame);
    else
      records_.append(encoder_.frame_record(*frame, words_of(explainer_->explanation())));
  }

 private:
  void begin(const RunHeader& header) {
    explainer_.emplace(header);
    const RecordWindow& window = records_.window();
    KeptWindow kept;
    if (window.bounds_seconds()) kept.seconds = window.seconds;
    if (window.bounds_bytes()) kept.characters = window.bytes;
    records_.append(encoder_.run_record(header, window.is_bounded() ? &kept : nullptr), RecordLog::Kind::first);
    records_.append(encoder_.map_record(header), RecordLog::Kind::first);
  }

  /// A part of the window begins with a record that says all.
  void append_to_window(const RunFrame& frame) {
    if (frame.starts) path_.clear();
    run_s_ += frame.starts ? 0 : frame.time_s - last_time_s_;
    last_time_s_ = frame.time_s;
    const bool is_part_full =
        records_.window().is_filled_by((run_s_ - part_run_s_) * kBeginnings, part_bytes_ * kBeginnings);
    const bool begins = frame.starts || is_part_full;
    const Restatement restatement{explainer_->state(), path_};
    std::string record = encoder_.frame_record(frame, words_of(explainer_->explanation()),
                                               begins && !frame.starts ? &restatement : nullptr);
    if (begins) part_run_s_ = run_s_;
    part_bytes_ = record.size() + (begins ? 0 : part_bytes_);
    records_.append(std::move(record), begins ? RecordLog::Kind::begins : RecordLog::Kind::follows, run_s_);
    if (const TracedHypothesis* best = explainer_->state().best()) path_.add(best->T_map_base.position());
  }

  RecordLog& records_;
  ThinnedPath path_;
  double run_s_ = 0, part_run_s_ = 0;  ///< of the run so far; when the newest part began
  double last_time_s_ = 0;             ///< of the time line
  std::size_t part_bytes_ = 0;         ///< of the newest part
  FrameBuilder builder_;
  PageEncoder encoder_;
  std::optional<Explainer> explainer_;
};

}  // namespace

struct LiveFeed::Implementation {
  explicit Implementation(RecordLog& log) : records(log), thread([this] { make_records(); }) {}

  void make_records();
  std::optional<nlohmann::ordered_json> next_event();
  void close(bool drop);

  RecordLog& records;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<nlohmann::ordered_json> queue;
  bool closed = false, dropped = false;
  std::exception_ptr failure;  ///< of the thread; read when it is over
  std::thread thread;          ///< last: it uses all of the above
};

void LiveFeed::Implementation::make_records() {
  try {
    RecordMaker maker(records);
    while (const auto event = next_event()) maker.take(*event);
  } catch (...) {
    failure = std::current_exception();
  }
  {
    std::lock_guard lock(mutex);
    closed = true;  // nobody takes events any more
    queue.clear();
  }
  records.end();
}

/// @return nullopt if no more events come.
std::optional<nlohmann::ordered_json> LiveFeed::Implementation::next_event() {
  std::unique_lock lock(mutex);
  changed.wait(lock, [this] { return closed || !queue.empty(); });
  if (dropped || queue.empty()) return std::nullopt;
  nlohmann::ordered_json event = std::move(queue.front());
  queue.pop_front();
  return event;
}

void LiveFeed::Implementation::close(bool drop) {
  {
    std::lock_guard lock(mutex);
    closed = true;
    dropped = drop;
  }
  changed.notify_one();
  thread.join();
}

LiveFeed::LiveFeed(RecordLog& records) : implementation_(std::make_unique<Implementation>(records)) {}

LiveFeed::~LiveFeed() {
  if (implementation_->thread.joinable()) implementation_->close(true);
}

void LiveFeed::write(const nlohmann::ordered_json& event) {
  nlohmann::ordered_json copy = event;
  {
    std::lock_guard lock(implementation_->mutex);
    if (implementation_->closed) return;
    implementation_->queue.push_back(std::move(copy));
  }
  implementation_->changed.notify_one();
}

void LiveFeed::end() {
  implementation_->close(false);
  if (implementation_->failure) std::rethrow_exception(implementation_->failure);
}

}  // namespace opal
