#pragma once

#include <opal/localization/events/event_stream.hpp>

#include <pybind11/pybind11.h>

#include <optional>

namespace opal::python {

/// Events as dicts, for a Python function. What it throws is kept until the localizer is done with its update: an
/// update is whole or does not begin.
class EventCallback final : public EventSink {
 public:
  explicit EventCallback(pybind11::object function) : function_(std::move(function)) {}

  bool listening() const override { return !failure_; }
  void write(const nlohmann::ordered_json& event) override;
  /// Throws what the function has thrown since; with the lock of Python.
  void rethrow();

 private:
  pybind11::object function_;
  std::optional<pybind11::error_already_set> failure_;
};

}  // namespace opal::python
