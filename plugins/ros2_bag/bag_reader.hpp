#pragma once

#include "bag_file.hpp"
#include "ros2_bag.hpp"
#include "static_frames.hpp"

#include <deque>

namespace opal::ros2_bag {

/// Walks the files of one recording, in order.
class BagReader final : public LogReader {
 public:
  /// @param files  by time; at least one.
  /// @param topics  the scan's is not empty.
  BagReader(std::vector<BagFile> files, TopicChoice topics);

  std::optional<LogRecord> next() override;
  std::map<std::string, int> defects() const override { return defects_; }
  double progress() const override;

 private:
  bool next_message();
  /// What a message holds for us; nothing and not damaged: it is about something else.
  struct Decoded {
    std::optional<LogRecord> record;
    bool damaged = false;
  };
  Decoded decode_current();
  Decoded odometry_of(Bytes transforms, double recorded_s) const;
  void find_mount();
  void find_odometry_transform();
  /// @return whether it leads from the frame of odometry to the robot.
  bool is_odometry(const Transform& transform) const;
  StaticFrames read_static_frames();
  template <class Message, class Decode>
  std::optional<Message> first_of(const std::string& topic, Decode decode) const;
  void turn_upright(RawScan& scan) const;

  std::vector<BagFile> files_;
  TopicChoice topics_;
  std::size_t file_ = 0;
  std::optional<BagFile::Messages> messages_;  // of that file; after files_, so that it goes first
  std::optional<MountRecord> mount_;           // not yet handed out
  bool upside_down_ = false;
  double reached_s_ = 0;
  bool transforms_are_odometry_ = false;  ///< no topic has odometry
  std::map<std::string, int> defects_;
};

}  // namespace opal::ros2_bag
