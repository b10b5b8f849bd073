#include "common/whole_file.hpp"
#include "common/text_file.hpp"
#include "common/write_error.hpp"

#include "tests/kit/file_content.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>

using namespace opal;
namespace fs = std::filesystem;

namespace {

std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a file keeps its old content until the new one is whole") {
  const TemporaryFolder folder;
  const std::string path = folder.write("map.jsonld", "old");
  WholeFile file(path);
  file.write("new");
  CHECK(content_of(path) == "old");
  file.finish();
  CHECK(content_of(path) == "new");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a file that is given up leaves nothing") {
  const TemporaryFolder folder;
  { WholeFile(folder.path_of("map.jsonld")).write("half"); }
  CHECK(files_in(folder) == 0);
}

TEST_CASE("a failure to write names the file and the cause") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(write_text("/dev/full", "text"), "/dev/full: cannot be written: No space left on device");
  CHECK_THROWS_WITH(write_text(folder.path(), "text"), folder.path() + ": cannot be written: Is a directory");
  CHECK_THROWS_AS(write_text(folder.path_of("absent/file"), "text"), WriteError);
  CHECK_THROWS_WITH(make_folder("/dev/null/folder"), "/dev/null/folder: the folder cannot be made: Not a directory");
}

TEST_CASE("a link stays a link, and permissions stay what they were") {
  const TemporaryFolder folder;
  const std::string real = folder.write("real", "old");
  fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(real, folder.path_of("link"));
  write_text(folder.path_of("link"), "new");
  CHECK(fs::is_symlink(folder.path_of("link")));
  CHECK(content_of(real) == "new");
  CHECK(fs::status(real).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("several may write one file at a time, and one of them is whole in the end") {
  const TemporaryFolder folder;
  const std::string path = folder.path_of("map.jsonld");
  WholeFile first(path), second(path);
  first.write(std::string(100'000, '1'));
  second.write(std::string(100'000, '2'));
  first.finish();
  CHECK(content_of(path) == std::string(100'000, '1'));
  second.finish();
  CHECK(content_of(path) == std::string(100'000, '2'));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a draft that somebody has left behind is in nobody's way") {
  const TemporaryFolder folder;
  for (int number = 0; number < 3; ++number)
    folder.write("map.jsonld." + std::to_string(getpid()) + "-" + std::to_string(number) + ".part", "left");
  write_text(folder.path_of("map.jsonld"), "new");
  CHECK(content_of(folder.path_of("map.jsonld")) == "new");
}
