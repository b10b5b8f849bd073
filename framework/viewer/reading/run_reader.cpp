#include "viewer/reading/run_reader.hpp"

#include "viewer/reading/event_text.hpp"
#include "viewer/reading/frame_builder.hpp"
#include "viewer/reading/line_reader.hpp"

#include <opal/common/error.hpp>
#include "output/unfinished_run.hpp"
#include "viewer/reading/id_format.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace opal {
namespace {

/// The event of a line; nullopt if the line is the last one and was cut off.
std::optional<Event> event_of(const LineReader& reader) {
  try {
    return parse_event(reader.line());
  } catch (const EventError&) {
    if (!reader.is_whole()) return std::nullopt;
    throw;
  }
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

void note_open_keyframe(const FrameBuilder& builder, RunReading& reading) {
  if (const auto keyframe = builder.open_keyframe())
    reading.notes.push_back(fmt::format("the stream ends within keyframe {}; what came before it is shown", *keyframe));
}

/// @return whether to go on
bool read_line(const LineReader& reader, FrameBuilder& builder, const FrameVisitor& visit, RunReading& reading) {
  const std::optional<Event> event = event_of(reader);
  if (!event) {
    reading.notes.push_back(fmt::format("line {} is cut off; what came before it is shown", reader.number()));
    return true;
  }
  std::optional<RunFrame> frame = builder.add(*event);
  if (!frame) return true;
  ++reading.frames;
  return visit(*builder.header(), std::move(*frame));
}

}  // namespace

std::string event_file(const std::string& out) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::exists(out, ignored)) throw EventError(out + ": does not exist, expected the folder of a run");
  if (!fs::is_directory(out, ignored)) return out;
  const std::string file = (fs::path(out) / "events.jsonl").string();
  if (!fs::exists(file, ignored))
    throw EventError(file + ": does not exist, expected the event stream that 'opal localize' writes");
  return file;
}

RunReading read_run(const std::string& out, const FrameVisitor& visit) {
  const std::string path = event_file(out);
  LineReader reader(path);
  FrameBuilder builder;
  RunReading reading;
  bool go_on = true;
  while (go_on && reader.next()) {
    if (is_blank(reader.line())) continue;
    try {
      go_on = read_line(reader, builder, visit, reading);
    } catch (const EventError& error) {
      const bool is_other_file = path == out && !builder.header();
      throw EventError(fmt::format("{}:{}: {}{}", path, reader.number(), error.what(),
                                   is_other_file ? "; expected a folder that 'opal localize' wrote" : ""));
    }
  }
  reading.header = builder.header();
  if (!reading.header)
    throw EventError(fmt::format("{}:{}: the stream ends before its 'map' event, expected 'run' and 'map' first", path,
                                 reader.number()));
  if (go_on) note_open_keyframe(builder, reading);
  const std::string unfinished = unfinished_note(std::filesystem::absolute(path).parent_path().string());
  if (!unfinished.empty()) reading.notes.push_back(unfinished);
  return reading;
}

}  // namespace opal
