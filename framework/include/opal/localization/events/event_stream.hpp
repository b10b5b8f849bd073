#pragma once

#include <opal/common/export.hpp>

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <memory>
#include <string>

namespace opal {

/// Receives what a run decides, as it decides it: one JSON object per event. Every event has "event" (its kind),
/// "stamp_s" and "keyframe"; docs/events.md lists the kinds and their fields.
class OPAL_EXPORT EventSink {
 public:
  virtual ~EventSink();
  /// False if nobody listens: callers then skip building events.
  virtual bool listening() const = 0;
  /// Takes one event. Events come in order of time, from the thread of the localizer.
  virtual void write(const nlohmann::ordered_json& event) = 0;
};

/// Nobody listens.
class OPAL_EXPORT NullEventSink final : public EventSink {
 public:
  bool listening() const override { return false; }
  /// Drops the event.
  void write(const nlohmann::ordered_json&) override {}
};

/// JSON Lines, one event per line, numbers with at most 6 significant decimals after the point.
class OPAL_EXPORT JsonLinesSink final : public EventSink {
 public:
  /// Writes to a stream, which must outlive the sink.
  explicit JsonLinesSink(std::ostream& out) : out_(out) {}
  bool listening() const override { return true; }
  /// Writes one line.
  void write(const nlohmann::ordered_json& event) override;

 private:
  std::ostream& out_;
};

}  // namespace opal
