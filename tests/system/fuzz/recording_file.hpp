#pragma once

#include <opal/recording/chunked_recording.hpp>

#include <cstdlib>
#include <sstream>

/// Reads a recording to its end by the way of a log source: all topics, all stamps, all messages by time.
inline void walk_to_the_end(const opal::recording::Recording& file) {
  const std::size_t stamps = file.stamps().size();
  std::vector<std::size_t> topics(file.topics().size());
  for (std::size_t i = 0; i < topics.size(); ++i) topics[i] = i;
  const auto walk = file.walk(topics);
  std::size_t messages = 0;
  unsigned sum = 0;
  while (const auto message = walk->next()) {
    for (const std::byte byte : message->data) sum += static_cast<unsigned>(byte);  // the sanitizer sees every byte
    if (message->topic >= topics.size()) std::abort();
    ++messages;
  }
  std::size_t left_out = 0;
  for (const auto& [cause, times] : walk->defects()) left_out += static_cast<std::size_t>(times);
  if (messages + left_out != stamps || sum == 0xffffffffu) std::abort();
}

inline std::unique_ptr<std::istream> stream_of(const std::uint8_t* data, std::size_t size) {
  return std::make_unique<std::istringstream>(std::string(reinterpret_cast<const char*>(data), size));
}
