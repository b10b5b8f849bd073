// Whatever the bytes of an event stream, reading it line by line ends with frames or with an opal::Error;
// frames that come out can be followed, explained, encoded and placed in a picture.
#include "viewer/encoding/page_encoder.hpp"
#include "viewer/reading/event_text.hpp"
#include "viewer/reading/frame_builder.hpp"
#include "viewer/scene/frame_scene.hpp"
#include "viewer/words/explanation.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace {

/// Everything that `opal view` and `opal explain` do with frames.
class Viewer {
 public:
  void take(const opal::RunHeader& header, const opal::RunFrame& frame) {
    if (!explainer_) explainer_.emplace(header);
    explainer_->take(frame);
    state_.apply(frame);
    const opal::Words words = opal::words_of(explainer_->explanation());
    // The page must be able to read what is written.
    if (!opal::parse_event(encoder_.frame_record(frame, words)).is_object()) throw std::logic_error("no record");
    opal::scene_of(header, state_, {});
  }

 private:
  std::optional<opal::Explainer> explainer_;
  opal::RunState state_;
  opal::PageEncoder encoder_;
};

void view(std::string_view text) {
  opal::FrameBuilder builder;
  Viewer viewer;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (const auto frame = builder.add(opal::parse_event(line))) viewer.take(*builder.header(), *frame);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    view({reinterpret_cast<const char*>(data), size});
  } catch (const opal::Error&) {
    return 0;
  }
  return 0;
}
