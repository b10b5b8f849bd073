#pragma once

#include <opal/recording/chunked_recording.hpp>

namespace opal::ros1_bag {

/// Whether a file begins as a bag of ROS 1 does; false if it cannot be read.
bool is_bag(const std::string& path);

/// Reads a bag of ROS 1 (http://wiki.ros.org/Bags/Format/2.0): chunks packed with bz2, lz4 or nothing. Bags that were
/// never closed, that were cut or that are damaged in places are read, too: what is not whole is left out and counted.
/// @throws LogError if it is no such bag; the message begins with the path.
std::unique_ptr<recording::Recording> read_bag(const std::string& path);
/// The same from a stream. @param name  what messages call it.
std::unique_ptr<recording::Recording> read_bag(std::unique_ptr<std::istream> stream, const std::string& name);

}  // namespace opal::ros1_bag
