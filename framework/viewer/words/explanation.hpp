#pragma once

#include "viewer/reading/run_frame.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace opal {

struct ExplainedMoment;
class RunState;

enum class SentenceKind { answer, support, against, alternative, fell, note };
const char* name_of(SentenceKind kind);

/// One thing to know about the answer. Names, times and numbers in it come from the event stream, or are computed
/// from what it holds (distances, counts); what is not recorded is not claimed.
struct Sentence {
  SentenceKind kind;
  std::string text;  ///< one line; names from the recording stand in it as they are
};

/// The sentences as (kind, text), as records have them (page/README.md).
std::vector<std::pair<std::string, std::string>> words_of(const std::vector<Sentence>& sentences);

/// Says why the localizer believes what it believes, from its recorded reasons. Takes the frames of a run in their
/// order and keeps no more of them than the newest moment needs.
class Explainer {
 public:
  /// @param header  of the run; must outlive the explainer.
  explicit Explainer(const RunHeader& header);
  ~Explainer();
  Explainer(Explainer&&) noexcept;
  Explainer& operator=(Explainer&&) noexcept;

  void take(const RunFrame& frame);

  /// The newest frame in words: the answer first, then what speaks for and against it, its alternatives, those that
  /// fell. Empty before the first frame. Deterministic, and independent of the order of a frame's unordered events.
  std::vector<Sentence> explanation() const;
  /// What holds after the newest frame; without the points where the robot was.
  const RunState& state() const;

 private:
  std::unique_ptr<ExplainedMoment> moment_;
};

}  // namespace opal
