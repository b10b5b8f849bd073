#include "benchmark/runs/view_page.hpp"

#include "viewer/html/page.hpp"
#include "viewer/words/explanation.hpp"

#include "common/text_file.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace opal::benchmark {
namespace {

/// Says what `opal explain` says, at every frame.
/// @param log  is set to the name of the run's log.
opal::Narrator explaining(std::string& log) {
  const auto explainer = std::make_shared<std::optional<opal::Explainer>>();
  return [explainer, &log](const opal::RunHeader& header, const opal::RunFrame& frame) {
    log = std::filesystem::path(header.log).filename().string();
    if (!*explainer) explainer->emplace(header);
    (*explainer)->take(frame);
    return opal::words_of((*explainer)->explanation());
  };
}

}  // namespace

std::vector<std::string> write_view_page(const std::vector<ViewedRun>& runs, const std::string& file) {
  std::vector<opal::PackedRun> packed;
  std::vector<std::string> notes, logs;
  for (const ViewedRun& run : runs) {
    std::string& log = logs.emplace_back();
    packed.push_back(
        opal::pack_run(run.out, run.name, opal::room_for_data(runs.size()), [&log] { return explaining(log); }));
    for (const auto* sentences : {&packed.back().notes, &packed.back().reduced})
      for (const std::string& sentence : *sentences) notes.push_back(run.out + ": " + sentence);
  }
  if (logs.size() == 2 && logs[0] != logs[1])
    notes.push_back("the runs are of two logs, " + logs[0] + " and " + logs[1] +
                    ": on one time line they show different moments, expected runs of one log");
  opal::write_text(file, opal::page_of(packed));
  return notes;
}

}  // namespace opal::benchmark
