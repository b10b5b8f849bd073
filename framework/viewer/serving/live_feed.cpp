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

/// Events in, records out.
class RecordMaker {
 public:
  explicit RecordMaker(RecordLog& records) : records_(records) {}

  void take(const nlohmann::ordered_json& event) {
    const std::optional<RunFrame> frame = builder_.add(as_written(event));
    if (!explainer_ && builder_.header()) begin(*builder_.header());
    if (!frame) return;
    explainer_->take(*frame);
    records_.append(encoder_.frame_record(*frame, words_of(explainer_->explanation())));
  }

 private:
  void begin(const RunHeader& header) {
    explainer_.emplace(header);
    records_.append(encoder_.run_record(header));
    records_.append(encoder_.map_record(header));
  }

  RecordLog& records_;
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
    implementation_->queue.push_back(std::move(copy));
  }
  implementation_->changed.notify_one();
}

void LiveFeed::end() {
  implementation_->close(false);
  if (implementation_->failure) std::rethrow_exception(implementation_->failure);
}

}  // namespace opal
