#include "cli/info/contents_text.hpp"
#include "cli/info/deployment_lines.hpp"
#include "cli/options/exit_code.hpp"
#include "cli/options/log_run_options.hpp"
#include "cli/options/verbs.hpp"
#include "session/session.hpp"

#include <opal/common/error.hpp>

#include <iostream>

namespace opal::cli {
namespace {

struct InfoOptions {
  std::string log, config = "default", out;
  std::vector<std::string> words;
  bool as_json = false;
};

int info(const InfoOptions& options) {
  const PluginRegistry registry = session::load_plugins();
  const std::string source = session::log_source_of(registry, options.log);
  const auto reader = session::log_source(registry, source, {}, options.words);
  LogContents contents = reader->contents(options.log);
  if (contents.format.empty()) contents.format = "log read by " + source;
  const nlohmann::ordered_json lines = deployment_lines(contents, source);
  if (!options.out.empty() && lines.empty())
    throw LogError(options.log + ": no laser that can be read, expected one for a deployment");
  if (options.as_json) {
    nlohmann::ordered_json json = contents_json(contents);
    json["deployment"] = lines;
    std::cout << json.dump(2) << '\n';
  } else {
    std::cout << contents_text(contents);
    if (!lines.empty()) std::cout << "\nfor the deployment (-o FILE writes one)\n" << lines.dump(2) << '\n';
  }
  if (!options.out.empty()) write_deployment(lines, options.config, options.out);
  if (const std::string doubt = doubt_of_lines(contents); !doubt.empty() && !options.as_json)
    std::cerr << "note: " << doubt << '\n';
  return lines.empty() ? kNo : kDone;
}

}  // namespace

void add_info_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* verb = app.add_subcommand("info", "what is in a recorded log, and what of it a deployment needs");
  verb->add_option("LOG", options->log, "recorded log, of any kind that a log source reads")->required();
  verb->add_flag("--json", options->as_json, "for programs: JSON, in metres, radians and seconds");
  verb->add_option("-o,--out", options->out, "deployment document to write: CONFIG with the laser of the log in it");
  verb->add_option("--config", options->config, "deployment document that -o starts from")->capture_default_str();
  add_log_words(*verb, options->words);
  verb->callback([options, &exit_code] { exit_code = info(*options); });
}

}  // namespace opal::cli
