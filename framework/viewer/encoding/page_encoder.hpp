#pragma once

#include "viewer/encoding/row_coder.hpp"
#include "viewer/encoding/thinned_path.hpp"
#include "viewer/reading/run_state.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace opal {

/// What is said about a moment: (kind, text) each; kinds as in framework/viewer/page/README.md.
using Words = std::vector<std::pair<std::string, std::string>>;

/// How much of a run its readers keep; what is not stated has no limit.
struct KeptWindow {
  std::optional<double> seconds;
  std::optional<std::size_t> characters;  ///< of records
};

/// What a reader has to know who begins in the middle of a run.
struct Restatement {
  const RunState& state;    ///< after the frame
  const ThinnedPath& path;  ///< before it
};

/// Turns a run into the records that the page reads, one by one. Each is one line of JSON, without the
/// newline.
class PageEncoder {
 public:
  explicit PageEncoder(const PageDetail& detail = {}) : detail_(detail), rows_(detail) {}

  /// @param window  of a run that goes on for longer than readers can keep it; null: they keep all.
  std::string run_record(const RunHeader& header, const KeptWindow* window = nullptr) const;
  std::string map_record(const RunHeader& header) const;
  /// Frames of a run come in order, none left out.
  /// @param restated  not null: the record says all that a reader has to know who begins with it.
  std::string frame_record(const RunFrame& frame, const Words& words = {}, const Restatement* restated = nullptr);

 private:
  void write_words(const Words& words, bool first, RecordText& record);

  const PageDetail detail_;
  RowCoder rows_;
  Words words_;  ///< of the frame before
};

}  // namespace opal
