#include "cli/ab/ab_bundle.hpp"

#include "benchmark/bundle/bundle_writer.hpp"
#include "benchmark/bundle/repeated_verdict.hpp"
#include "cli/options/exit_code.hpp"
#include "common/digest/sha256.hpp"

#include <opal/common/error.hpp>

#include <filesystem>
#include <iostream>

namespace opal::cli {
namespace {

namespace ab = ab;
namespace fs = std::filesystem;

void expect_finished(const AbSession& session) {
  for (const char* name : {"results.jsonl", "verdict.json"})
    if (const std::string file = session.folder().file(name); !fs::exists(file))
      throw ConfigError(file + ": is not there, expected a finished experiment; opal ab " + session.experiment().file +
                        " finishes it");
}

void say(const std::string& head, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return;
  std::cout << head << '\n';
  for (const std::string& sentence : sentences) std::cout << "  " << sentence << '\n';
}

void say_what_differs(const ab::RepeatedVerdict& told) {
  say("made with other parts:", told.made_with);
  say("cells:", told.cells);
  say("measured costs, which are never twice the same:", told.costs);
  say("the verdict differs from that of the bundle:", told.verdict);
  if (told.cells.empty()) std::cout << "every cell came out as in the bundle\n";
  if (told.same()) std::cout << "the verdict is that of the bundle\n";
}

std::string digest_of_bundle(const ab::Bundle& bundle) { return sha256_of_file(bundle.path_of(ab::kBundleFile)); }

fs::path out_of_bundle(const AbOptions& options) {
  if (!options.out.empty()) return options.out;
  return fs::path("out") / (fs::canonical(options.bundle).filename().string() + "_repeated");
}

}  // namespace

int bundle_experiment(const AbOptions& options) {
  AbSession session(options);
  expect_finished(session);
  constexpr double kBytesPerMb = 1e6;
  const std::string folder = options.bundle.empty() ? session.folder().file("bundle") : options.bundle;
  const std::string command = "opal ab " + session.experiment().file + " -o " + session.folder().path();
  const ab::Bundle bundle =
      write_bundle(session.experiment(), session.manifest(), session.worlds(), session.folder(),
                   {folder, command, static_cast<std::uint64_t>(options.largest_mb * kBytesPerMb)});
  for (const ab::BundledFile& file : bundle.files)
    if (!file.included) std::cout << "not included: " << file.name << ", SHA-256 " << file.sha256 << '\n';
  std::cout << "written: " << bundle.files.size() << " files and " << ab::kBundleFile << " in " << folder << '\n'
            << "SHA-256 of " << ab::kBundleFile << ": " << digest_of_bundle(bundle) << '\n'
            << "opal ab repeat " << folder << " repeats the verdict\n";
  return kDone;
}

int repeat_bundle(const AbOptions& options) {
  const ab::Bundle bundle = ab::read_bundle(options.bundle);
  std::cout << "bundle.json has SHA-256 " << digest_of_bundle(bundle) << ", every file is as it was\n";
  const fs::path out = out_of_bundle(options), inputs = out / "inputs";
  place_files(bundle, options.places, inputs.string());
  AbOptions inside = options;
  inside.experiment = (inputs / ab::kBundledExperiment).string();
  inside.out = out.string();
  AbSession session(inside);
  session.work(ab::Shard{}, jobs_of(options));
  if (!session.collect()) return kNo;
  const ab::RepeatedVerdict told = compare_with(bundle, session.folder());
  say_what_differs(told);
  return told.same() ? kDone : kNo;
}

}  // namespace opal::cli
