#include "small_experiment.hpp"

#include "benchmark/cells/ab_report.hpp"
#include "common/digest/sha256.hpp"
#include "tests/system/server/program.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace opal::ab_tests;
using Catch::Contains;
using nlohmann::json;
using opal::TemporaryFolder;
using opal::store_tests::Finished;
using opal::store_tests::opal_run;

namespace {

namespace fs = std::filesystem;

/// A recorded place, a generated building and a map, judged by what is the same on every machine.
json bundled_experiment() {
  json experiment = small_experiment();
  experiment["sites"][0]["queries"] = {"malaga-demo-q01", "malaga-demo-q05"};
  experiment["simulated"] = {
      {{"name", "corridor"}, {"building", {{"kind", "corridor"}, {"size_m2", 300}}}, {"distance_m", 4}, {"seeds", 2}},
      {{"name", "room"}, {"map", std::string(OPAL_SOURCE_DIR) + "/maps/example_room.jsonld"}, {"distance_m", 3}}};
  experiment["metrics"] = {"success", "distance_to_success_m", "honest"};
  return experiment;
}

/// A bundle whose experiment is gone: only the bundle is left.
class MadeBundle {
 public:
  /// A copy of one that this process makes once.
  MadeBundle() : said_(once().said_), results_(once().results_), verdict_(once().verdict_) {
    fs::copy(once().path(), path(), fs::copy_options::recursive);
  }

  explicit MadeBundle(const std::vector<std::string>& more) {
    const std::string experiment = written(folder_, bundled_experiment());
    run({"ab", experiment, "-o", folder_.path_of("out")});
    std::vector<std::string> words{"ab", "bundle", experiment, "-o", folder_.path_of("out"), "--to", path()};
    words.insert(words.end(), more.begin(), more.end());
    said_ = run(words);
    results_ = content_of(folder_.path_of("out/results.jsonl"));
    verdict_ = content_of(folder_.path_of("out/verdict.json"));
    fs::remove_all(folder_.path_of("out"));
    fs::remove(experiment);
  }

  std::string path() const { return folder_.path_of("bundle"); }
  std::string path_of(const std::string& name) const { return path() + "/" + name; }
  std::string again() const { return folder_.path_of("again"); }
  const std::string& said() const { return said_; }
  const std::string& results() const { return results_; }
  const std::string& verdict() const { return verdict_; }
  Finished repeat(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"ab", "repeat", path(), "-o", again()};
    words.insert(words.end(), more.begin(), more.end());
    return opal_run(words);
  }

  /// Another content of a file; the list says that it belongs there.
  void forge(const std::string& name, const std::string& content) const {
    write(name, content);
    json list = json::parse(content_of(path_of("bundle.json")));
    for (json& file : list["files"])
      if (file["name"] == name) file["sha256"] = opal::sha256_of(content);
    write("bundle.json", list.dump());
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(path_of(name), std::ios::binary) << content;
  }

 private:
  static const MadeBundle& once() {
    static const MadeBundle made(std::vector<std::string>{});
    return made;
  }

  static std::string run(const std::vector<std::string>& words) {
    const Finished done = opal_run(words);
    INFO(done.said);
    REQUIRE(done.exit_code == 0);
    return done.said;
  }

  TemporaryFolder folder_;
  std::string said_, results_, verdict_;
};

}  // namespace

TEST_CASE("a bundle repeats its experiment to the byte, without the files that it was made from") {
  const MadeBundle bundle;
  const Finished again = bundle.repeat();
  INFO(again.said);
  CHECK(again.exit_code == 0);
  CHECK_THAT(again.said, Contains("every cell came out as in the bundle"));
  CHECK_THAT(again.said, Contains("the verdict is that of the bundle"));
  CHECK_THAT(again.said, !Contains("made with other parts"));
  CHECK(content_of(bundle.again() + "/results.jsonl") == bundle.results());
  CHECK(content_of(bundle.again() + "/verdict.json") == bundle.verdict());
  const json list = json::parse(content_of(bundle.path_of("bundle.json")));
  CHECK_THAT(list["command"].get<std::string>(), Contains("opal ab ") && Contains("small.jsonld"));
  CHECK(list["seeds"]["corridor"] == json{1, 2});
  CHECK(list["opal"]["library_sha256"].get<std::string>().size() == 64);
  CHECK_THAT(bundle.said(), Contains("SHA-256 of bundle.json: " + opal::sha256_of_file(bundle.path_of("bundle.json"))));
}

TEST_CASE("a bundle with a file that was changed, is missing, or was added is refused by the file and its place") {
  const MadeBundle bundle;
  const std::string name = "places/malaga-demo/malaga-demo.queries.json";
  SECTION("changed") {
    bundle.write(name, content_of(bundle.path_of(name)) + " ");
    const Finished again = bundle.repeat();
    CHECK(again.exit_code == 3);
    CHECK_THAT(again.said, Contains("bundle.json: /files/") && Contains(bundle.path_of(name) + " has SHA-256 ") &&
                               Contains("it was changed since the bundle was made"));
  }
  SECTION("missing") {
    fs::remove(bundle.path_of(name));
    const Finished again = bundle.repeat();
    CHECK(again.exit_code == 3);
    CHECK_THAT(again.said, Contains("/files/") && Contains(bundle.path_of(name) + " is not there"));
  }
  SECTION("added") {
    bundle.write("places/malaga-demo/malaga-demo.map.jsonld", "{}");
    const Finished again = bundle.repeat();
    CHECK(again.exit_code == 3);
    CHECK_THAT(again.said, Contains("malaga-demo.map.jsonld: is not in the list of bundle.json"));
  }
  SECTION("a name that leads out of the bundle") {
    json list = json::parse(content_of(bundle.path_of("bundle.json")));
    list["files"][0]["name"] = "../outside";
    bundle.write("bundle.json", list.dump());
    const Finished again = bundle.repeat();
    CHECK(again.exit_code == 3);
    CHECK_THAT(again.said, Contains("/files/0/name") && Contains("expected a path below the bundle's folder"));
  }
  CHECK_FALSE(fs::exists(bundle.again()));
}

TEST_CASE("a repeated verdict that differs is told, and is a no") {
  const MadeBundle bundle;
  json verdict = json::parse(bundle.verdict());
  verdict[0]["metrics"][0]["outcome"] = "worse";
  verdict[0]["metrics"][1]["pairs"] = 77;
  bundle.forge("verdict.json", verdict.dump());
  std::string results = bundle.results();
  results.replace(results.find("\"success\":1.0"), 13, "\"success\":0.0");
  bundle.forge("results.jsonl", results);
  const Finished again = bundle.repeat();
  INFO(again.said);
  CHECK(again.exit_code == 1);
  CHECK_THAT(again.said, Contains("lack_of_fit, success: outcome was \"worse\" and is \""));
  CHECK_THAT(again.said, Contains("lack_of_fit, distance_to_success_m: pairs was 77 and is "));
  CHECK_THAT(again.said, Contains("1 of 10 cells came out differently") && Contains("success was 0 and is 1"));
}

TEST_CASE("recordings that a bundle only names are looked for by their SHA-256") {
  const MadeBundle bundle({"--largest", "0.01"});
  CHECK_THAT(bundle.said(), Contains("not included: places/malaga-demo/malaga-demo.log.gz, SHA-256 "));
  const Finished without = bundle.repeat();
  CHECK(without.exit_code == 3);
  CHECK_THAT(without.said, Contains("these files are not part of the bundle, and were not found") &&
                               Contains("malaga-demo.log.gz (16154 bytes, SHA-256 ") && Contains("--look-in FOLDER"));
  const Finished found = bundle.repeat({"--look-in", std::string(OPAL_SOURCE_DIR) + "/maps"});
  INFO(found.said);
  CHECK(found.exit_code == 0);
  CHECK(content_of(bundle.again() + "/results.jsonl") == bundle.results());
}

TEST_CASE("a verdict is repeated in what is computed; what is measured is told") {
  const TemporaryFolder folder;
  json document = small_experiment();
  document["sites"][0]["queries"] = {"malaga-demo-q01"};
  document["metrics"] = {"success", "hypotheses", "cpu_ms", "cpu_ms_p99", "peak_mb"};
  const std::string experiment = written(folder, document), out = folder.path_of("out");
  const std::string bundle = folder.path_of("bundle");
  REQUIRE(opal_run({"ab", experiment, "-o", out}).exit_code == 0);
  REQUIRE(opal_run({"ab", "bundle", experiment, "-o", out, "--to", bundle}).exit_code == 0);
  const Finished again = opal_run({"ab", "repeat", bundle, "-o", folder.path_of("again")});
  INFO(again.said);
  CHECK_THAT(again.said, !Contains("hypotheses: "));
  for (const char* measured : {"cpu_ms", "cpu_ms_p99", "peak_mb"})
    CHECK_THAT(again.said, Contains(std::string("lack_of_fit, ") + measured + ": difference was "));
  for (const char* number : {"baseline", "interval", "p "})
    CHECK_THAT(again.said, !Contains(std::string("cpu_ms: ") + number));
}

TEST_CASE("the metrics that are measured are the costs of cells") {
  const TemporaryFolder folder;
  json document = small_experiment();
  document["sites"][0]["queries"] = {"malaga-demo-q01"};
  const std::string out = folder.path_of("out");
  REQUIRE(opal_run({"ab", written(folder, document), "-o", out}).exit_code == 0);
  const auto first_of = [&](const char* name) {
    const std::string text = content_of(out + "/" + name);
    return json::parse(text.substr(0, text.find('\n')));
  };
  const json costs = first_of("times.jsonl").at("costs"), values = first_of("results.jsonl").at("values");
  for (const char* name : {"cpu_ms", "cpu_ms_p99", "peak_mb"}) {
    CHECK(opal::benchmark::is_measured(name));
    CHECK(costs.contains(name));
  }
  for (const auto& [name, value] : values.items()) CHECK_FALSE(opal::benchmark::is_measured(name));
}

TEST_CASE("only a finished experiment becomes a bundle, in a folder of its own") {
  const TemporaryFolder folder;
  const std::string experiment = written(folder, bundled_experiment()), out = folder.path_of("out");
  const Finished early = opal_run({"ab", "bundle", experiment, "-o", out});
  CHECK(early.exit_code == 3);
  CHECK_THAT(early.said, Contains("results.jsonl: is not there, expected a finished experiment"));
  REQUIRE(opal_run({"ab", experiment, "-o", out}).exit_code == 0);
  const Finished taken = opal_run({"ab", "bundle", experiment, "-o", out, "--to", out});
  CHECK(taken.exit_code == 3);
  CHECK_THAT(taken.said, Contains("expected a folder that is empty or not there"));
}

TEST_CASE("the tables and figures of a verdict are there for papers") {
  const TemporaryFolder folder;
  const std::string out = folder.path_of("out");
  json document = bundled_experiment();
  document["metrics"].push_back("cpu_ms");
  REQUIRE(opal_run({"ab", written(folder, document), "-o", out}).exit_code == 0);
  for (const char* name :
       {"lack_of_fit_evidence", "lack_of_fit_evidence_numbers", "lack_of_fit_evidence_distance_to_success_m_sites",
        "lack_of_fit_evidence_distance_to_success_m_pairs"})
    for (const char* ending : {".csv", ".md", ".tex"}) CHECK(fs::exists(out + "/paper/" + name + ending));
  for (const char* name : {"cpu_ms_sites", "distance_to_success_m_pairs"})
    for (const char* ending : {".svg", ".pdf"}) CHECK(fs::exists(out + "/paper/lack_of_fit_evidence_" + name + ending));
  CHECK_THAT(content_of(out + "/paper/lack_of_fit_evidence.tex"), Contains("lack\\_of\\_fit"));
  CHECK_THAT(content_of(out + "/paper/lack_of_fit_evidence.csv"),
             Contains("metric,evidence,lack_of_fit,difference,95 % interval,outcome") && !Contains("later"));
}
