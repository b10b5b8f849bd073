#pragma once

#include "recording/fixed_frames.hpp"
#include "recording/ros_topics.hpp"

namespace opal::recording {

// cos 10 deg: a laser that is tilted more sees floor and ceiling within a few metres.
constexpr double kUprightCosine = 0.985;

/// Walks the files of one recording, in order.
class RosLogReader final : public LogReader {
 public:
  /// @param parts  by time; at least one.
  RosLogReader(Parts parts, ChosenTopics chosen);

  std::optional<LogRecord> next() override;
  std::map<std::string, int> defects() const override;
  double progress() const override;

 private:
  /// What a message holds for us; nothing and not damaged: it is about something else.
  struct Decoded {
    std::optional<LogRecord> record;
    bool damaged = false;
  };
  std::optional<Message> next_message();
  Decoded decode(const Message& message, const Topic& topic, double recorded_s) const;
  Decoded odometry_of(const Message& message, Wire wire, double recorded_s) const;
  std::string base_frame_of(const FixedFrames& frames, const std::string& laser_frame) const;
  void find_mount();
  SeenTransforms read_transforms(bool with_moving);
  template <class Wanted, class Decoder>
  std::optional<Wanted> first_of(const std::string& topic, Decoder decoder) const;
  void turn_upright(RawScan& scan) const;

  Parts parts_;
  TopicChoice topics_;
  std::vector<Span> spans_;  // of the parts
  std::size_t part_ = 0;
  std::unique_ptr<MessageWalk> walk_;  // of that part; after parts_, so that it goes first
  std::optional<MountRecord> mount_;   // not yet handed out
  bool upside_down_ = false;
  double reached_s_ = 0;
  bool transforms_are_odometry_ = false;  // no topic has odometry
  Defects defects_;
};

}  // namespace opal::recording
