#pragma once

#include "viewer/reading/run_header_events.hpp"

#include <memory>
#include <optional>

namespace opal {

/// Turns an event stream into frames, event by event. It checks everything, so that whoever gets a frame can
/// rely on it: numbers are finite and at most 1e6 m from the origin, ids of mapped features are positions in
/// the header, a hypothesis stands once among those that are alive.
class FrameBuilder {
 public:
  /// @return the frame that this event completes (it is its `cost`); nullopt if it completes none.
  /// @throws EventError "KIND: POINTER: what was found, what was expected"; the builder is then of no further
  /// use.
  std::optional<RunFrame> add(const Event& event);

  /// What `run` and `map` said; null before `map`.
  const std::shared_ptr<const RunHeader>& header() const { return header_; }
  /// The keyframe that has begun and is not complete yet.
  std::optional<KeyframeId> open_keyframe() const;

 private:
  std::optional<RunFrame> dispatch(const std::string& kind, const EventPlace& event);
  void begin_run(const EventPlace& event);
  void begin_map(const EventPlace& event);
  void begin_time_line(const EventPlace& event);
  void begin_frame(const EventPlace& event);
  RunFrame end_frame(const EventPlace& event);
  void require_open(const EventPlace& event) const;
  void require_closed(const EventPlace& event) const;

  std::optional<RunHeader> run_;  ///< until `map` completes it
  std::shared_ptr<const RunHeader> header_;
  FeaturePositions features_;
  std::vector<StampedPose> truth_;             ///< T_map_base of the time line, by increasing stamp
  std::optional<std::string> starts_ = "run";  ///< the time line that the next frame begins
  double first_stamp_s_ = 0, newest_stamp_s_ = 0;
  std::optional<RunFrame> frame_;
  bool answered_ = false;  ///< the open frame has its estimate
};

}  // namespace opal
