#include "small_experiment.hpp"

#include "benchmark/ab/records/journal.hpp"
#include "tests/kit/sanitized.hpp"
#include "tests/system/server/program.hpp"

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <thread>

using namespace opal::ab_tests;
using nlohmann::json;
using opal::TemporaryFolder;
using opal::store_tests::Finished;
using opal::store_tests::opal_run;
using opal::store_tests::Program;

namespace {

namespace fs = std::filesystem;

std::vector<json> lines_of(const std::string& path) {
  std::vector<json> lines;
  for (const std::string& line : opal::lines_of(content_of(path))) lines.push_back(json::parse(line));
  return lines;
}

/// Results of a run to the end in a folder of its own.
std::string computed(const std::string& experiment, const std::string& out, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"ab", experiment, "-o", out};
  words.insert(words.end(), more.begin(), more.end());
  const Finished run = opal_run(words);
  INFO(run.said);
  REQUIRE(run.exit_code == 0);
  return content_of(out + "/results.jsonl");
}

/// What one process computes, once for all tests.
const std::string& reference() {
  static const std::string results = [] {
    const TemporaryFolder folder;
    return computed(written(folder, experiment_with_drives()), folder.path_of("one"), {"--jobs", "1"});
  }();
  return results;
}
constexpr std::size_t kCells = 22;

}  // namespace

TEST_CASE("results do not depend on how many processes or shards compute them, nor how often they stop") {
  const TemporaryFolder folder;
  const std::string experiment = written(folder, experiment_with_drives());
  const std::string& expected = reference();
  SECTION("three processes") {
    CHECK(computed(experiment, folder.path_of("three"), {"--jobs", "3"}) == expected);
    CHECK(lines_of(folder.path_of("three/results.jsonl")).size() == kCells);
    CHECK(lines_of(folder.path_of("three/times.jsonl")).size() == kCells);
  }
  SECTION("three shards, the last one first") {
    const std::string out = folder.path_of("shards");
    CHECK(opal_run({"ab", "work", experiment, "-o", out, "--shard", "3/3"}).exit_code == 0);
    const Finished early = opal_run({"ab", "collect", experiment, "-o", out});
    CHECK(early.exit_code == 1);
    CHECK_THAT(early.said, Catch::Contains(" of 22 cells are finished"));
    CHECK_FALSE(fs::exists(out + "/results.jsonl"));
    for (const char* shard : {"1/3", "2/3"})
      CHECK(opal_run({"ab", "work", experiment, "-o", out, "--shard", shard}).exit_code == 0);
    CHECK(opal_run({"ab", "collect", experiment, "-o", out}).exit_code == 0);
    CHECK(content_of(out + "/results.jsonl") == expected);
  }
  SECTION("killed ten times") {
    const std::string out = folder.path_of("killed");
    std::mt19937 random(7);
    std::uniform_int_distribution<int> pause_ms(30, 400);
    int killed = 0;
    for (int k = 0; k < 10; ++k) {
      Program program({"ab", experiment, "-o", out, "--jobs", "2"});
      std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms(random)));
      program.kill_at_once();
      killed += program.wait().exit_code == -1;
    }
    CAPTURE(killed);
    CHECK(killed > 0);
    CHECK(computed(experiment, out) == expected);
    std::size_t lines = 0;
    for (const auto& journal : fs::directory_iterator(out + "/journals"))
      lines += lines_of(journal.path().string()).size();
    CHECK(lines == kCells);  // none was computed twice
  }
}

TEST_CASE("cells that Ctrl-C or scancel interrupts are no failures of their arms") {
  const TemporaryFolder folder;
  const std::string experiment = written(folder, small_experiment()), out = folder.path_of("out");
  for (int k = 0; k < 3; ++k) {
    const std::string command = "timeout --signal=" + std::string(k % 2 ? "TERM" : "INT") + " 0." +
                                std::to_string(2 + k) + " \"$OPAL_PROGRAM\" ab " + experiment + " -o " + out + " > " +
                                folder.path_of("said") + " 2>&1";
    std::system(command.c_str());  // timeout signals the whole group of processes
  }
  CHECK(computed(experiment, out) == computed(experiment, folder.path_of("undisturbed")));
}

TEST_CASE("an arm that crashes, hangs, throws, leaves or eats memory has failures, and the others their results") {
  const TemporaryFolder folder;
  json experiment = small_experiment();
  experiment["arms"] = {experiment["arms"][0],  faulty_arm("crash", 1), faulty_arm("hang", 1),
                        faulty_arm("throw", 1), faulty_arm("leave", 1), faulty_arm("eat", 1)};
  json unborn = faulty_arm("crash", 0);
  unborn["name"] = "unborn";
  experiment["arms"].push_back(unborn);
  const int cell_s = kIsSanitized ? 30 : 5, memory_mb = kIsSanitized ? 1000 : 300;
  experiment["limits"] = {{"cell_s", cell_s}, {"memory_mb", memory_mb}};
  experiment["sites"][0]["queries"] = {"malaga-demo-q01", "malaga-demo-q05"};
  const std::string out = folder.path_of("out"), file = written(folder, experiment);
  computed(file, out);
  CHECK_THAT(opal_run({"ab", "collect", file, "-o", out}).said,
             Catch::Contains("throw: 2 cells failed in a plugin: faulty:Scorer\n") &&
                 Catch::Contains("what the failed cells said: see the logs in " + out + "/logs\n"));
  std::map<std::string, std::set<std::string>> failures;
  for (const json& line : lines_of(out + "/results.jsonl")) failures[line["arm"]].insert(line["failure"]);
  CHECK(failures["evidence"] == std::set<std::string>{""});
  CHECK(failures["crash"] == std::set<std::string>{"crashed: signal 6 (SIGABRT)"});
  CHECK(failures["hang"] == std::set<std::string>{fmt::format("hung: over {} s", cell_s)});
  CHECK(failures["throw"] == std::set<std::string>{"failed in a plugin: faulty:Scorer 1 times"});
  CHECK(failures["leave"] == std::set<std::string>{"ended by itself with 3"});
  CHECK(failures["eat"] == std::set<std::string>{fmt::format("out of memory: over {} MB", memory_mb)});
  CHECK(failures["unborn"] == std::set<std::string>{"in its set-up: crashed: signal 6 (SIGABRT)"});
}

TEST_CASE("arms that observe judge the same hypotheses, and change nothing") {
  const TemporaryFolder folder;
  json document = small_experiment();
  document["mode"] = "observe";
  document["arms"].push_back(faulty_arm("crash", 1));
  document["arms"].push_back(document["arms"][0]);
  document["arms"].back()["name"] = "evidence_again";
  computed(written(folder, document), folder.path_of("out"));
  std::map<std::string, std::map<std::string, json>> by_query;
  for (const json& line : lines_of(folder.path_of("out/results.jsonl"))) by_query[line["query"]][line["arm"]] = line;
  REQUIRE(by_query.size() == 5);
  double contests = 0;
  for (const auto& [query, arms] : by_query) {
    CAPTURE(query);
    CHECK(arms.at("crash")["failure"] == "crashed: signal 6 (SIGABRT)");
    CHECK(arms.at("lack_of_fit")["input"] == arms.at("evidence")["input"]);
    CHECK(arms.at("lack_of_fit")["values"]["success"] == arms.at("evidence")["values"]["success"]);
    CHECK(arms.at("evidence_again")["values"] == arms.at("evidence")["values"]);
    CHECK(arms.at("lack_of_fit")["values"] != arms.at("evidence")["values"]);
    contests += arms.at("evidence")["values"].value("contests", 0.0);
  }
  CHECK(contests > 0);
}

TEST_CASE("a scorer with a memory that observes judges as if it decided: each has a memory of its own") {
  const TemporaryFolder folder;
  json document = small_experiment();
  document["mode"] = "observe";
  const json arm = {{"name", "beams"}, {"overrides", {{"scorers", {{{"@type", "opal:Beams"}}}}}}};
  json again = arm;
  again["name"] = "beams_again";
  document["arms"] = {arm, again};
  document["baseline"] = "beams";
  computed(written(folder, document), folder.path_of("out"));
  std::map<std::string, std::map<std::string, json>> by_query;
  for (const json& line : lines_of(folder.path_of("out/results.jsonl"))) by_query[line["query"]][line["arm"]] = line;
  REQUIRE(by_query.size() == 5);
  double contests = 0;
  for (const auto& [query, arms] : by_query) {
    CAPTURE(query);
    CHECK(arms.at("beams_again")["values"] == arms.at("beams")["values"]);
    CHECK(arms.at("beams_again")["input"] == arms.at("beams")["input"]);
    contests += arms.at("beams")["values"].value("contests", 0.0);
  }
  CHECK(contests > 0);
}

TEST_CASE("an experiment may be looked at before its end as often as it says") {
  const TemporaryFolder folder;
  json document = small_experiment();
  document["looks"] = 2;
  const std::string experiment = written(folder, document), out = folder.path_of("out");
  const auto collected = [&] { return opal_run({"ab", "collect", experiment, "-o", out}).said; };
  const auto work = [&](const std::string& shard) {
    REQUIRE(opal_run({"ab", "work", experiment, "-o", out, "--shard", shard}).exit_code == 0);
  };
  work("1/5");
  CHECK_THAT(collected(), Catch::Contains("looks are at every 5 cells, once"));
  work("2/3");
  CHECK_THAT(collected(), Catch::Contains("lack_of_fit") && Catch::Contains("look"));
  work("4/5");  // the same look again
  CHECK_THAT(collected(), Catch::Contains("looks are at every 5 cells, once"));
  work("1/1");
  CHECK_THAT(collected(), Catch::Contains("lack_of_fit") && Catch::Contains("written: results.jsonl"));
}

TEST_CASE("arms that were given different logs are refused when they are collected") {
  const TemporaryFolder folder;
  const std::string experiment = written(folder, small_experiment()), out = folder.path_of("out");
  computed(experiment, out, {"--jobs", "1"});
  const std::string journal = out + "/journals/1-of-1.0.jsonl";
  // As another machine would have written it whose simulator rounds differently.
  std::string text;
  opal::ab::read_journal(journal, [&](const opal::ab::CellResult& result, opal::ab::JournalPlace) {
    opal::ab::CellResult other = result;
    if (result.number == 3) other.input = "0123456789abcdef";
    text += opal::ab::journal_line(other) + "\n";
  });
  folder.write("out/journals/1-of-1.0.jsonl", text);
  const Finished collected = opal_run({"ab", "collect", experiment, "-o", out});
  CHECK(collected.exit_code == 3);
  CHECK_THAT(
      collected.said,
      Catch::Contains("malaga-demo-q02/1/lack_of_fit 0123456789abcdef, expected the same map and log for all arms"));
}

TEST_CASE("arms that judged different hypotheses of one log are told so") {
  const TemporaryFolder folder;
  const std::string experiment = written(folder, small_experiment()), out = folder.path_of("out");
  computed(experiment, out, {"--jobs", "1"});
  std::string text;
  opal::ab::read_journal(out + "/journals/1-of-1.0.jsonl",
                         [&](const opal::ab::CellResult& result, opal::ab::JournalPlace) {
                           opal::ab::CellResult other = result;
                           other.input += result.number == 3 ? "/b" : "/a";
                           text += opal::ab::journal_line(other) + "\n";
                         });
  folder.write("out/journals/1-of-1.0.jsonl", text);
  const Finished collected = opal_run({"ab", "collect", experiment, "-o", out});
  CHECK(collected.exit_code == 3);
  CHECK_THAT(collected.said, Catch::Contains("judge different hypotheses of the same log") &&
                                 Catch::Contains("give all arms the folder"));
}

TEST_CASE("a second run of the same cells is refused, and says who is at work") {
  const TemporaryFolder folder;
  json document = small_experiment();
  document["arms"].push_back(faulty_arm("hang", 1));
  const std::string experiment = written(folder, document), out = folder.path_of("out");
  Program first({"ab", experiment, "-o", out});
  for (int k = 0; k < 500 && !fs::exists(out + "/journals/1-of-1.0.jsonl"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const Finished second = opal_run({"ab", experiment, "-o", out});
  CHECK(second.exit_code == 5);
  CHECK_THAT(second.said, Catch::Contains("computes these cells already"));
}
