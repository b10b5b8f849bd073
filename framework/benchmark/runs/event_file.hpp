#pragma once

#include <opal/localization/events/event_stream.hpp>

#include <sstream>
#include <string>

namespace opal::benchmark {

/// The event stream of a run as a file. The file ends with a whole event at any moment, also when the disk is full or
/// the program is killed.
class EventFile final : public opal::EventSink {
 public:
  /// @throws opal::WriteError naming the file and the cause.
  explicit EventFile(const std::string& path);
  /// Writes what is left, if that is possible.
  ~EventFile() override;
  EventFile(const EventFile&) = delete;
  EventFile& operator=(const EventFile&) = delete;

  bool listening() const override { return true; }
  /// @throws opal::WriteError
  void write(const nlohmann::ordered_json& event) override;
  /// Everything is on the disk. @throws opal::WriteError
  void finish();

 private:
  void flush();

  std::string path_;
  std::ostringstream lines_;  ///< whole ones that are not in the file yet
  opal::JsonLinesSink sink_{lines_};
  int file_ = -1;
  long written_ = 0;  ///< bytes, up to the end of a line
};

}  // namespace opal::benchmark
