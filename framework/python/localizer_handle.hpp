#pragma once

#include "benchmark/runs/event_file.hpp"
#include "python/event_callback.hpp"
#include "python/map.hpp"
#include "python/replay.hpp"
#include "python/run.hpp"

#include <opal/deployment/deployment.hpp>
#include <opal/localization/scoring/hypothesis.hpp>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

namespace opal::python {

/// A hypothesis as it was at a keyframe.
struct HypothesisHandle {
  Hypothesis hypothesis;
  Pose2 T_map_base;  ///< at that keyframe
};

/// A localizer as Python holds it: with its deployment, and with who listens to its events.
class LocalizerHandle {
 public:
  /// @param map  none: that of the deployment. @param events  None, a function that takes dicts, or the path of a file.
  LocalizerHandle(Deployment deployment, const std::optional<MapHandle>& map, const pybind11::object& events);

  /// One thread at a time; the lock of Python is free while `work` runs. @throws std::runtime_error for a second one.
  template <class Work>
  auto apart(Work&& work);

  std::optional<PoseEstimate> update(const Sample& sample);
  benchmark::RunRecord run(ReplayHandle& replay, const std::string& query);
  void reset(const std::string& name);
  /// Writes what is left of an event file. @throws WriteError
  void finish_events();

  const Deployment& deployment() const { return deployment_; }
  const MapHandle& map() const { return map_; }
  /// For questions; with the lock of Python. @throws std::runtime_error while another thread updates it.
  Localizer& localizer();

 private:
  /// Marks the localizer as in use.
  class Use {
   public:
    explicit Use(std::atomic<bool>& busy);
    ~Use() { busy_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    std::atomic<bool>& busy_;
  };

  EventSink* listen(const pybind11::object& events);
  /// A time line in the event stream.
  void begin(const std::string& name);
  void rethrow_callback();

  Deployment deployment_;
  MapHandle map_;
  std::unique_ptr<EventCallback> callback_;
  std::unique_ptr<benchmark::EventFile> file_;
  EventSink* events_ = nullptr;
  std::unique_ptr<Localizer> localizer_;
  std::atomic<bool> busy_ = false;
  bool begun_ = false;  ///< the event stream knows of a time line
};

template <class Work>
auto LocalizerHandle::apart(Work&& work) {
  const Use use(busy_);
  auto result = [&] {
    const pybind11::gil_scoped_release others_run;
    return work(*localizer_);
  }();
  rethrow_callback();
  return result;
}

}  // namespace opal::python
