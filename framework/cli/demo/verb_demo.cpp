#include "cli/options/verbs.hpp"
#include "common/whole_file.hpp"
#include "session/shipped_files.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace opal::cli {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Runs a command as if it had been typed, and shows it before.
int run_command(Words words) {
  std::cout << "\n$ opal";
  for (const std::string& word : words) std::cout << ' ' << word;
  std::cout << std::endl;
  CLI::App app("", "opal");
  int exit_code = 0;
  add_map_verb(app, exit_code);
  add_localize_verb(app, exit_code);
  add_view_verb(app, exit_code);
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  app.parse(words);
  return exit_code;
}

int demo(const std::string& out) {
  const fs::path data = session::shipped_file("maps/malaga"), folder = out;
  const std::string map = (folder / "malaga.jsonld").string();
  make_folder(out);
  const std::vector<Words> commands{{"map", "import", data / "malaga.map.yaml", "-o", map, "--svg", folder / "map.svg"},
                                    {"localize", session::shipped_config("malaga.jsonld"), data / "malaga.log.gz",
                                     "--map", map, "--truth", data / "malaga.gt.csv", "-o", out},
                                    {"view", out}};
  for (const Words& command : commands)
    if (const int exit_code = run_command(command); exit_code != 0) return exit_code;
  std::cout << "\nlook at it: open " << fs::absolute(folder / "view.html").lexically_normal().string()
            << " in a browser\n";
  return 0;
}

}  // namespace

void add_demo_verb(CLI::App& app, int& exit_code) {
  auto out = std::make_shared<std::string>("opal-demo");
  CLI::App* verb = app.add_subcommand(
      "demo", "a first run: import the map of a hall, localize along a recorded drive, make the page");
  verb->add_option("-o,--out", *out, "folder for everything that it writes")->capture_default_str();
  verb->callback([out, &exit_code] { exit_code = demo(*out); });
}

}  // namespace opal::cli
