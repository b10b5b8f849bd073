#pragma once

#include <opal/recording/chunked_recording.hpp>

namespace opal::recording {

/// Whether a file begins as an MCAP file does; false if it cannot be read.
bool is_mcap(const std::string& path);

/// Reads an MCAP file (https://mcap.dev/spec): chunked or not, indexed or not, packed with lz4, zstd or nothing. CRCs
/// are checked where the file has them. What is not whole is left out and counted.
/// @throws LogError if it is no MCAP file; the message begins with the path.
std::unique_ptr<Recording> read_mcap(const std::string& path);
/// The same from a stream. @param name  what messages call it.
std::unique_ptr<Recording> read_mcap(std::unique_ptr<std::istream> stream, const std::string& name);

}  // namespace opal::recording
