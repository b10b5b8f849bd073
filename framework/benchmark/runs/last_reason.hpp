#pragma once

#include <opal/localization/events/event_stream.hpp>

#include <string>

/// Hands every event on, and remembers why the newest status is what it is.
class LastReason final : public opal::EventSink {
 public:
  explicit LastReason(opal::EventSink& next) : next_(next) {}

  bool listening() const override { return true; }
  void write(const nlohmann::ordered_json& event) override {
    if (const auto why = event.find("why"); why != event.end() && why->is_string()) why_ = *why;
    next_.write(event);
  }
  /// In words; empty before the first update.
  const std::string& why() const { return why_; }

 private:
  opal::EventSink& next_;
  std::string why_;
};
