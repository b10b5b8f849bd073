#include "benchmark/runs/view_page.hpp"

#include "viewer/html/page.hpp"
#include "viewer/words/explanation.hpp"

#include <opal/common/error.hpp>
#include "common/text_file.hpp"

#include <memory>
#include <optional>

namespace {

/// Says what `opal explain` says, at every frame.
opal::Narrator explaining() {
  const auto explainer = std::make_shared<std::optional<opal::Explainer>>();
  return [explainer](const opal::RunHeader& header, const opal::RunFrame& frame) {
    if (!*explainer) explainer->emplace(header);
    (*explainer)->take(frame);
    return opal::words_of((*explainer)->explanation());
  };
}

}  // namespace

std::vector<std::string> write_view_page(const std::vector<ViewedRun>& runs, const std::string& file) {
  std::vector<opal::PackedRun> packed;
  std::vector<std::string> notes;
  for (const ViewedRun& run : runs) {
    packed.push_back(opal::pack_run(run.out, run.name, opal::room_for_data(runs.size()), explaining));
    for (const auto* sentences : {&packed.back().notes, &packed.back().reduced})
      for (const std::string& sentence : *sentences) notes.push_back(run.out + ": " + sentence);
  }
  opal::write_text(file, opal::page_of(packed));
  return notes;
}
