#pragma once

#include "recording/record_decoder.hpp"

#include <deque>

namespace opal::recording {

// A transform that stands still for so long, from the start of a recording, is taken for a mount.
constexpr double kMountWindow_s = 5;

/// Walks the files of one recording, in order.
class RosLogReader final : public LogReader {
 public:
  /// @param parts  by time, those without messages last; at least one.
  RosLogReader(Parts parts, ChosenTopics chosen);

  std::optional<LogRecord> next() override;
  std::map<std::string, int> defects() const override;
  double progress() const override;

 private:
  std::optional<Message> next_message();
  std::string base_frame_of(const FixedFrames& frames, const std::string& laser_frame) const;
  void find_mounts();
  void find_mount(FixedFrames& frames, const std::string& laser_frame);
  void add_still_links(FixedFrames& frames);
  SeenTransforms read_transforms(bool with_moving);
  template <class Wanted, class Decoder>
  std::optional<Wanted> first_of(const std::string& topic, Decoder decoder) const;

  Parts parts_;
  RecordDecoder decoder_;
  std::vector<Span> spans_;  // of the parts
  double end_s_ = 0;         // of the last one
  std::size_t part_ = 0;
  std::unique_ptr<MessageWalk> walk_;  // of that part; after parts_, so that it goes first
  std::deque<MountRecord> mounts_;     // not yet handed out
  bool knows_still_links_ = false;     // of /tf
  double reached_s_ = 0;
  Defects defects_;
};

}  // namespace opal::recording
