#include "cli/map/map_frame.hpp"
#include "cli/options/exit_code.hpp"

#include "session/session.hpp"

#include <opal/common/strict_json.hpp>
#include "common/text_file.hpp"
#include "map_tools/map_frame.hpp"

#include <filesystem>
#include <iostream>
#include <memory>

namespace opal::cli {
namespace {

struct FrameVerbOptions {
  std::string map, frame, out;
};

/// A document as it is written; of any other source, that of the map that it gives.
NamedDocument read_document(const std::string& source) {
  const std::string extension = std::filesystem::path(source).extension().string();
  if (extension == ".jsonld" || extension == ".json") return {read_json(source), source};
  return {nlohmann::json(session::load_map(session::load_plugins(), source)->to_json_ld()), source};
}

int frame(const FrameVerbOptions& options) {
  const nlohmann::json framed = framed_map(read_document(options.map), {read_json(options.frame), options.frame});
  const std::size_t matches = matches_in(framed);
  if (options.out.empty()) {
    std::cout << framed.dump(1) << '\n';
  } else {
    write_text(options.out, framed.dump(1) + '\n');
    std::cout << "written: " << options.out << ", " << matches << (matches == 1 ? " match\n" : " matches\n");
  }
  return matches == 0 ? kNo : kDone;
}

}  // namespace

void add_map_frame(CLI::App& map, int& exit_code) {
  auto options = std::make_shared<FrameVerbOptions>();
  CLI::App* verb = map.add_subcommand("frame", "ask a map for nodes of some shape (W3C JSON-LD 1.1 Framing)");
  verb->add_option("MAP", options->map, "map document, or a source to import")->required();
  verb->add_option("--frame", options->frame, "frame (.jsonld): which nodes, and what to tell of them")->required();
  verb->add_option("-o,--out", options->out, "file to write; the terminal if it is left out");
  verb->callback([options, &exit_code] { exit_code = frame(*options); });
}

}  // namespace opal::cli
