#include "cli/options/exit_code.hpp"
#include "cli/options/verbs.hpp"

#include "report/quantity_text.hpp"
#include "viewer/words/explanation.hpp"
#include "viewer/words/moment.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <optional>

namespace opal::cli {
namespace {

struct ExplainOptions {
  std::string out, at = "end", query;
  bool as_json = false;
};

/// What is known of the explained moment besides the words.
struct ExplainedFrame {
  std::string time_line;
  double time_s = 0, stamp_s = 0;
  KeyframeId keyframe;
};

/// Names come from a recording: on a terminal they must not move the cursor or change colours.
std::string without_control_characters(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

void print_text(const ExplainedFrame& frame, const std::vector<Sentence>& sentences) {
  std::cout << without_control_characters(frame.time_line) << " at " << seconds_text(frame.time_s) << " (keyframe "
            << frame.keyframe << ", stamp " << fixed_text(frame.stamp_s, 3) << ")\n";
  for (const Sentence& sentence : sentences) {
    std::string kind = name_of(sentence.kind);
    kind.resize(8, ' ');
    std::cout << kind << without_control_characters(sentence.text) << '\n';
  }
}

void print_json(const ExplainedFrame& frame, const std::vector<Sentence>& sentences) {
  nlohmann::ordered_json words = nlohmann::ordered_json::array();
  for (const Sentence& sentence : sentences) words.push_back({name_of(sentence.kind), sentence.text});
  std::cout << nlohmann::ordered_json{{"query", frame.time_line},
                                      {"time_s", frame.time_s},
                                      {"stamp_s", frame.stamp_s},
                                      {"keyframe", frame.keyframe},
                                      {"words", words}}
                   .dump(2)
            << '\n';
}

int explain(const ExplainOptions& options) {
  const Moment moment = parse_moment(options.at, options.query);
  std::optional<Explainer> explainer;
  ExplainedFrame newest;
  const auto reading = read_until(options.out, moment, [&](const RunHeader& header, const RunFrame& frame) {
    if (!explainer) explainer.emplace(header);
    explainer->take(frame);
    newest = {frame.starts.value_or(newest.time_line), frame.time_s, frame.stamp_s, frame.keyframe};
  });
  const auto sentences = explainer->explanation();
  options.as_json ? print_json(newest, sentences) : print_text(newest, sentences);
  for (const std::string& note : reading.notes) std::cerr << "opal: " << options.out << ": " << note << '\n';
  return kDone;
}

}  // namespace

void add_explain_verb(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* verb = app.add_subcommand("explain", "why it believed what it believed at a moment of a run, in words");
  verb->add_option("OUT", options->out, "folder that 'opal localize -o' wrote")->required();
  verb->add_option("--at", options->at, "seconds since the start (12.5), a stamp of the log (stamp:1626.25), or 'end'")
      ->capture_default_str();
  verb->add_option("--query", options->query,
                   "name of the query, if the run has several (default: the first; at the "
                   "end: the last)");
  verb->add_flag("--json", options->as_json, "print JSON");
  verb->callback([options, &exit_code] { exit_code = explain(*options); });
}

}  // namespace opal::cli
