#include "output/output_folder.hpp"

#include "output/unfinished_run.hpp"
#include "tests/kit/refusal.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>

using namespace opal;
namespace fs = std::filesystem;

TEST_CASE("a folder is marked while a run writes into it, and not when the run is finished") {
  const TemporaryFolder parent;
  const std::string path = parent.path_of("a/b");
  OutputFolder folder(path, "opal localize", {});
  const auto run = unfinished_run(path);
  REQUIRE(run);
  CHECK(run->is_running);
  CHECK(run->command == "opal localize");
  CHECK(run->process == getpid());
  CHECK_THAT(unfinished_note(path), Catch::StartsWith("this run is not finished: opal localize (process "));
  folder.finish();
  CHECK_FALSE(unfinished_run(path));
  CHECK(fs::is_empty(path));
}

TEST_CASE("a folder belongs to one run at a time, and the other is told to whom") {
  const TemporaryFolder parent;
  OutputFolder folder(parent.path(), "opal localize", {});
  const std::string told = refused_with<Error>([&] { OutputFolder(parent.path(), "opal track", {}); });
  CHECK_THAT(told, Catch::StartsWith(parent.path() + ": opal localize (process " + std::to_string(getpid())));
  CHECK_THAT(told, Catch::EndsWith("writes into this folder; wait for its end, or give another folder"));
  CHECK_THROWS_AS(OutputFolder(parent.path(), "opal track", {}), FolderInUse);
  folder.finish();
  CHECK_NOTHROW(OutputFolder(parent.path(), "opal track", {}).finish());
}

TEST_CASE("a run that ends by an error or a signal leaves the mark, which says so") {
  const TemporaryFolder parent;
  { const OutputFolder folder(parent.path(), "opal bench", {}); }
  auto run = unfinished_run(parent.path());
  REQUIRE(run);
  CHECK_FALSE(run->is_running);
  CHECK_THAT(unfinished_note(parent.path()), Catch::EndsWith("ended with an error"));
  OutputFolder(parent.path(), "opal bench", {}).interrupt(SIGTERM);
  CHECK_THAT(unfinished_note(parent.path()), Catch::EndsWith("was interrupted (SIGTERM)"));
}

TEST_CASE("what an earlier run left is removed by name, and nothing else is") {
  const TemporaryFolder parent;
  for (const char* name : {"results.csv", "drive_1.svg", "drive_22.svg", "notes.txt"}) parent.write(name, "old");
  fs::create_directory(parent.path_of("drive_3.svg"));
  OutputFolder folder(parent.path(), "opal drive", {"results.csv", "drive_*.svg", "absent.json"});
  CHECK_FALSE(fs::exists(parent.path_of("results.csv")));
  CHECK_FALSE(fs::exists(parent.path_of("drive_1.svg")));
  CHECK_FALSE(fs::exists(parent.path_of("drive_22.svg")));
  CHECK(fs::exists(parent.path_of("notes.txt")));
  CHECK(fs::exists(parent.path_of("drive_3.svg")));
}

TEST_CASE("a mark with any content is a mark") {
  const TemporaryFolder parent;
  for (const char* content : {"", "{", "[1, 2]", R"({"process": "seven", "command": 3})"}) {
    parent.write(kUnfinishedMarker, content);
    CHECK(unfinished_note(parent.path()) == "this run was not finished: a program was killed");
  }
}
