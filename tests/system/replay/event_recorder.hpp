#pragma once

#include <opal/localization/events/event_stream.hpp>

#include <vector>

/// Keeps all events.
class EventRecorder final : public opal::EventSink {
 public:
  bool listening() const override { return true; }
  void write(const nlohmann::ordered_json& event) override { events.push_back(event); }
  std::vector<nlohmann::ordered_json> events;
};
