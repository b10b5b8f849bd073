#include "ros2/message_recorder.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <filesystem>

using opal::TemporaryFolder;
using opal::ros2::FileRecorder;

TEST_CASE("a recording goes into the next free name, and what was recorded before stays") {
  const TemporaryFolder folder;
  const std::string file = folder.path_of("drive.mcap");
  FileRecorder first(file);
  first.finish();
  const auto bytes = std::filesystem::file_size(file);
  CHECK(bytes > 0);
  FileRecorder second(file), third(file);  // two nodes at one time
  CHECK(first.path() == file);
  CHECK(second.path() == folder.path_of("drive-2.mcap"));
  CHECK(third.path() == folder.path_of("drive-3.mcap"));
  CHECK(std::filesystem::file_size(file) == bytes);
}

TEST_CASE("a recording that cannot be made is told") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(FileRecorder(folder.path_of("nope/drive.mcap")), opal::Error);
}
