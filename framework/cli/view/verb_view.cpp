#include "benchmark/runs/view_page.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/picture_files.hpp"
#include "cli/options/verbs.hpp"

#include "viewer/scene/frame_scene.hpp"
#include "viewer/words/explanation.hpp"
#include "viewer/words/moment.hpp"

#include <filesystem>
#include <iostream>
#include <optional>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;

struct ViewOptions {
  std::vector<std::string> outs;
  std::string file, at = "end", query;
  PictureFiles picture;
};

/// What the page calls a run: its folder, or more of the path if two folders have the same name.
std::string name_of_run(const ViewOptions& options, std::size_t which) {
  const auto leaf = [&](std::size_t k) { return fs::path(options.outs[k]).lexically_normal().filename().string(); };
  const bool twins = options.outs.size() == 2 && leaf(0) == leaf(1);
  return twins || leaf(which).empty() ? options.outs[which] : leaf(which);
}

fs::path page_file(const ViewOptions& options) {
  if (!options.file.empty()) return options.file;
  const fs::path out = options.outs.front();
  return (fs::is_directory(out) ? out : out.parent_path()) / "view.html";
}

int write_page(const ViewOptions& options) {
  std::vector<benchmark::ViewedRun> runs;
  for (std::size_t k = 0; k < options.outs.size(); ++k) runs.push_back({options.outs[k], name_of_run(options, k)});
  const std::string file = page_file(options).string();
  for (const std::string& note : benchmark::write_view_page(runs, file)) std::cerr << "opal: " << note << '\n';
  std::cout << "written: " << file << '\n';
  return kDone;
}

int draw_moment(const ViewOptions& options) {
  const std::string& out = options.outs.front();
  const Moment moment = parse_moment(options.at, options.query);
  std::optional<Explainer> explainer;
  RunState state;
  const auto reading = read_until(out, moment, [&](const RunHeader& header, const RunFrame& frame) {
    if (!explainer) explainer.emplace(header);
    explainer->take(frame);
    state.apply(frame);
  });
  std::vector<std::string> notes;
  for (const Sentence& sentence : explainer->explanation())
    notes.push_back(std::string(name_of(sentence.kind)) + ": " + sentence.text);
  for (const std::string& note : reading.notes) notes.push_back("note: " + note);
  const DrawingScene scene = scene_of(*reading.header, state, notes);
  options.picture.write(scene);
  for (const std::string& file : {options.picture.svg, options.picture.png})
    if (!file.empty()) std::cout << "written: " << file << '\n';
  return kDone;
}

int view(const ViewOptions& options) {
  if (options.picture.svg.empty() && options.picture.png.empty()) {
    if (options.at != "end" || !options.query.empty())
      throw CLI::ValidationError("--at and --query choose the moment of a picture, expected --svg or --png");
    return write_page(options);
  }
  if (options.outs.size() != 1) throw CLI::ValidationError("a picture shows one run, expected one OUT");
  draw_moment(options);
  return options.file.empty() ? 0 : write_page(options);
}

}  // namespace

void add_view_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* verb = app.add_subcommand("view", "look at a run, or at two of one log: one HTML file for the browser");
  verb->add_option("OUT", options->outs, "folder that 'opal localize -o' wrote; two to compare them")
      ->required()
      ->expected(1, 2);
  verb->add_option("-o,--out", options->file, "file to write (default: OUT/view.html)");
  options->picture.add_to(*verb, "draw one moment into this file instead");
  verb->add_option("--at", options->at,
                   "which: seconds since the start (12.5), a stamp of the log (stamp:1626.25), or 'end'")
      ->capture_default_str();
  verb->add_option("--query", options->query,
                   "name of the query, if the run has several (default: the first; at the "
                   "end: the last)");
  verb->callback([options, &exit_code] { exit_code = view(*options); });
}

}  // namespace opal::cli
