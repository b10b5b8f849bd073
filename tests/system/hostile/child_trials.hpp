#pragma once

#include <functional>
#include <string>
#include <vector>

/// What reading one damaged file came to.
struct Trial {
  enum class Result { refused, accepted, failed };
  Result result = Result::failed;
  std::string message;  ///< of the error; or what is wrong
};

/// Limits for each file: 10 s of processor time, 3 GiB of address space.
/// @param read  takes a file's path and text; returns "" if it made a map of it that holds all it should, or what is
/// wrong;
///   throws opal::MapError if it refuses the file, whose message must name it.
/// @return as many as texts. A child process that dies or hangs fails the text it was reading; a new one goes on after
/// it.
std::vector<Trial> read_in_children(
    const std::string& file_name, const std::vector<std::string>& texts,
    const std::function<std::string(const std::string& path, const std::string& text)>& read);
