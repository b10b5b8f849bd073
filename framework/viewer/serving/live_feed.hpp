#pragma once

#include "viewer/serving/record_log.hpp"

#include <opal/localization/events/event_stream.hpp>

#include <memory>

namespace opal {

/// Turns the events of a run that goes on into records, with explanations, in a thread of its own. Whoever writes
/// events never waits for that: `write` appends a copy to a queue without an end, whatever becomes of it afterwards. If
/// the log has a window, some records say all that a reader has to know who begins with them.
class LiveFeed final : public EventSink {
 public:
  /// @param records  gets what comes out; must outlive the feed.
  explicit LiveFeed(RecordLog& records);
  /// Drops what is still in the queue.
  ~LiveFeed() override;

  bool listening() const override { return true; }
  void write(const nlohmann::ordered_json& event) override;

  /// The run is over: waits until all of its events are records, and ends the log. Call it at most once, after the last
  /// `write`. @throws EventError if an event was not understood; the log ended there.
  void end();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opal
