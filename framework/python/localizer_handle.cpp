#include "python/localizer_handle.hpp"

#include "localization/events/run_events.hpp"
#include "python/plugins.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>

#include <stdexcept>

namespace opal::python {

namespace py = pybind11;

LocalizerHandle::Use::Use(std::atomic<bool>& busy) : busy_(busy) {
  if (busy.exchange(true))
    throw std::runtime_error("the localizer is in the middle of an update, expected one user at a time");
}

EventSink* LocalizerHandle::listen(const py::object& events) {
  if (events.is_none()) return nullptr;
  if (PyCallable_Check(events.ptr()) != 0) {
    callback_ = std::make_unique<EventCallback>(events);
    return callback_.get();
  }
  file_ = std::make_unique<benchmark::EventFile>(py::str(events).cast<std::string>());
  return file_.get();
}

LocalizerHandle::LocalizerHandle(Deployment deployment, const std::optional<MapHandle>& map, const py::object& events)
    : deployment_(std::move(deployment)), events_(listen(events)) {
  if (!map && deployment_.map.empty())
    throw ConfigError(deployment_.file + ": /map: missing; name a map there, or give one to the localizer");
  {
    const py::gil_scoped_release others_run;
    const auto plugins = registry();
    map_ = map ? *map : MapHandle{session::load_map(*plugins, deployment_)};
    LocalizerParts parts = build_parts(deployment_, *plugins, map_.map);
    if (events_ != nullptr) {
      const std::string& source = map ? map->map->name() : deployment_.map;
      events_->write(run_event({"", deployment_.file, source}, parts.lasers.front()));
      events_->write(map_event(*parts.map));
    }
    localizer_ = std::make_unique<Localizer>(std::move(parts), events_);
  }
  rethrow_callback();
}

void LocalizerHandle::rethrow_callback() {
  if (callback_) callback_->rethrow();
}

void LocalizerHandle::begin(const std::string& name) {
  if (events_ != nullptr) events_->write(start_event(name));
  begun_ = true;
}

std::optional<PoseEstimate> LocalizerHandle::update(const Sample& sample) {
  return apart([&](Localizer& localizer) {
    if (!begun_) begin("run");
    return localizer.update(sample);
  });
}

benchmark::RunRecord LocalizerHandle::run(ReplayHandle& replay, const std::string& query) {
  return apart([&](Localizer& localizer) {
    localizer.reset();
    begin(query);
    return benchmark::run_log(localizer, deployment_.lasers.front(), replay.replay, query, {Interruptible(), {}, {}});
  });
}

void LocalizerHandle::reset(const std::string& name) {
  apart([&](Localizer& localizer) {
    localizer.reset();
    begin(name);
    return true;
  });
}

void LocalizerHandle::finish_events() {
  apart([&](Localizer&) {
    if (file_) file_->finish();
    return true;
  });
}

Localizer& LocalizerHandle::localizer() {
  const Use use(busy_);
  return *localizer_;
}

}  // namespace opal::python
