#include "viewer/reading/frame_builder.hpp"

#include "viewer/reading/frame_events.hpp"

#include <opal/common/error.hpp>
#include "viewer/reading/id_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace opal {

std::optional<RunFrame> FrameBuilder::add(const Event& event) {
  const EventPlace place(event);
  const std::string& kind = place.member("event").name();
  try {
    return dispatch(kind, place);
  } catch (const EventError& error) {
    throw EventError(kind + ": " + error.what());
  }
}

std::optional<KeyframeId> FrameBuilder::open_keyframe() const {
  return frame_ ? std::optional(frame_->keyframe) : std::nullopt;
}

std::optional<RunFrame> FrameBuilder::dispatch(const std::string& kind, const EventPlace& event) {
  if (kind == "run") {
    begin_run(event);
  } else if (!run_) {
    event.member("event").fail(
        "'run' as the first event; streams that begin otherwise were written by an older version of Opal: "
        "run 'opal localize' again");
  } else if (kind == "map") {
    begin_map(event);
  } else if (kind == "start") {
    begin_time_line(event);
  } else if (kind == "truth") {
    require_closed(event);
    truth_ = read_truth_event(event);
  } else if (kind == "keyframe") {
    begin_frame(event);
  } else if (kind == "cost") {
    return end_frame(event);
  } else if (is_frame_event(kind)) {
    require_open(event);
    read_frame_event(kind, event, features_, *frame_);
    answered_ = answered_ || kind == "estimate";
  }
  return std::nullopt;
}

void FrameBuilder::begin_run(const EventPlace& event) {
  if (run_) event.member("event").fail("one 'run' per stream, as its first event");
  read_run_event(event, run_.emplace());
}

void FrameBuilder::begin_map(const EventPlace& event) {
  if (header_) event.member("event").fail("one 'map' per stream");
  features_ = read_map_event(event, *run_);
  header_ = std::make_shared<const RunHeader>(*run_);
}

void FrameBuilder::begin_time_line(const EventPlace& event) {
  require_closed(event);
  const auto query = event.find("query");
  starts_ = query ? query->name() : "run";
  truth_ = {};
}

void FrameBuilder::begin_frame(const EventPlace& event) {
  if (!header_) event.member("event").fail("'map' before the first keyframe");
  require_closed(event);
  RunFrame frame;
  read_frame_event("keyframe", event, features_, frame);
  if (starts_) first_stamp_s_ = newest_stamp_s_ = frame.stamp_s;
  const double set_back_s =
      std::max(0.0, newest_stamp_s_ - frame.stamp_s);  // a robot's clock may be; its drive goes on
  first_stamp_s_ -= set_back_s;
  newest_stamp_s_ = frame.stamp_s;
  frame.time_s = frame.stamp_s - first_stamp_s_;
  frame.starts = std::exchange(starts_, std::nullopt);
  frame.truth = pose_at(truth_, frame.stamp_s);
  frame_ = std::move(frame);
  answered_ = false;
}

RunFrame FrameBuilder::end_frame(const EventPlace& event) {
  require_open(event);
  if (!answered_) event.member("event").fail("'estimate' before it");
  read_frame_event("cost", event, features_, *frame_);
  return *std::exchange(frame_, std::nullopt);
}

void FrameBuilder::require_open(const EventPlace& event) const {
  const EventPlace keyframe = event.member("keyframe");
  if (!frame_) keyframe.fail("a 'keyframe' event that begins this update");
  if (keyframe.id<KeyframeId>() != frame_->keyframe)
    keyframe.fail(fmt::format("{}, the open keyframe", frame_->keyframe));
}

void FrameBuilder::require_closed(const EventPlace& event) const {
  if (frame_) event.member("event").fail(fmt::format("'cost' of keyframe {} first", frame_->keyframe));
}

}  // namespace opal
