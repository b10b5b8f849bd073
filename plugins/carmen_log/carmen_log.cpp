#include "carmen_log.hpp"

#include "carmen_line.hpp"
#include "gz_lines.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace opal::carmen_log {
namespace {

/// The CARMEN messages at the starts of lines.
std::set<std::string, std::less<>> messages_in(std::string_view text) {
  std::set<std::string, std::less<>> messages;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view message = message_of(text.substr(0, end));
    if (is_carmen_message(message)) messages.emplace(message);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return messages;
}

std::string main_laser(const std::set<std::string, std::less<>>& messages) {
  for (const char* laser : {"FLASER", "ROBOTLASER1", "RAWLASER1", "RLASER"})
    if (messages.contains(laser)) return laser;
  return "FLASER";
}

class CarmenReader final : public LogReader {
 public:
  CarmenReader(GzLines lines, std::vector<std::string> laser_messages)
      : lines_(std::move(lines)), laser_messages_(std::move(laser_messages)) {}

  std::optional<LogRecord> next() override {
    while (const std::optional<Line> line = lines_.next()) {
      ParsedLine parsed = parse_line(line->text, line->terminated, laser_messages_);
      if (!has_scans_) look_for_lasers(line->text, parsed);
      if (parsed.defect) ++defects_[parsed.defect];
      if (parsed.record) return std::move(parsed.record);
    }
    return std::nullopt;
  }
  std::map<std::string, int> defects() const override {
    std::map<std::string, int> all = defects_;
    if (lines_.overlong() > 0) all["line of more than 4 MB"] = lines_.overlong();
    if (lines_.damage()) all[lines_.damage()] = 1;
    if (!has_scans_ && !other_lasers_.empty()) all[words_of_others()] = 1;
    return all;
  }
  double progress() const override { return lines_.progress(); }

 private:
  /// Until the first scan: lines of lasers that are not read.
  void look_for_lasers(std::string_view text, const ParsedLine& parsed) {
    has_scans_ = parsed.record && std::holds_alternative<RawScan>(*parsed.record);
    const std::string_view message = message_of(text);
    const bool is_read = std::find(laser_messages_.begin(), laser_messages_.end(), message) != laser_messages_.end();
    if (!is_read && is_laser_message(message)) other_lasers_.emplace(message);
  }
  std::string words_of_others() const {
    std::string words;
    for (const std::string& message : other_lasers_) words += (words.empty() ? "" : ", ") + message;
    return "no scan of " + laser_messages_.front() + "; the option laser_message can name one of " + words;
  }

  GzLines lines_;
  bool has_scans_ = false;
  std::set<std::string, std::less<>> other_lasers_;
  std::vector<std::string> laser_messages_;
  std::map<std::string, int> defects_;
};

}  // namespace

CarmenLog::CarmenLog(const std::string& laser_messages) {
  std::istringstream words(laser_messages);
  for (std::string message; words >> message;) {
    if (!is_laser_message(message))
      throw ConfigError("option laser_message: \"" + message +
                        "\", expected FLASER, RLASER, LASERn, ROBOTLASERn, RAWLASERn or nothing");
    laser_messages_.push_back(std::move(message));
  }
}

bool CarmenLog::recognizes(const std::string& path) const {
  try {
    GzLines lines(path);
    return !messages_in(lines.peek()).empty();
  } catch (const std::exception&) {
    return false;
  }
}

std::unique_ptr<LogReader> CarmenLog::open(const std::string& path) const {
  GzLines lines(path);
  const auto messages = messages_in(lines.peek());
  if (messages.empty())
    throw LogError(path + ": no line at its start begins with a CARMEN message such as ODOM or FLASER" +
                   (lines.damage() ? std::string(" (") + lines.damage() + ")" : ""));
  return std::make_unique<CarmenReader>(std::move(lines),
                                        laser_messages_.empty() ? std::vector{main_laser(messages)} : laser_messages_);
}

}  // namespace opal::carmen_log
