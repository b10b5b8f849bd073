#pragma once

#include "synthetic_run.hpp"
#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"
#include "viewer/reading/frame_builder.hpp"

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace opal::synthetic {

/// The event stream of a synthetic run, as `opal localize` would write it.
inline std::string text_of(const RunSize& size) {
  std::ostringstream out;
  JsonLinesSink sink(out);
  write_run(size, sink);
  return out.str();
}

struct EventFile : TemporaryFile {
  explicit EventFile(const std::string& text) : TemporaryFile("run.jsonl", text) {}
  void cut_to(std::size_t bytes) const { std::filesystem::resize_file(path(), bytes); }
};

struct ReadRun {
  std::shared_ptr<const RunHeader> header;
  std::vector<RunFrame> frames;
};

inline ReadRun frames_of(const RunSize& size) {
  FrameBuilder builder;
  ReadRun run;
  for (const std::string& line : lines_of(text_of(size)))
    if (auto frame = builder.add(Event::parse(line))) run.frames.push_back(*std::move(frame));
  run.header = builder.header();
  return run;
}

}  // namespace opal::synthetic
