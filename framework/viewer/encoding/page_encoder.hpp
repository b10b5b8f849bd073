#pragma once

#include "viewer/encoding/row_coder.hpp"

#include <string>
#include <utility>
#include <vector>

namespace opal {

/// What is said about a moment: (kind, text) each; kinds as in framework/viewer/page/README.md.
using Words = std::vector<std::pair<std::string, std::string>>;

/// Turns a run into the records that the page reads, one by one. Each is one line of JSON, without the
/// newline.
class PageEncoder {
 public:
  explicit PageEncoder(const PageDetail& detail = {}) : detail_(detail), rows_(detail) {}

  std::string run_record(const RunHeader& header) const;
  std::string map_record(const RunHeader& header) const;
  /// Frames of a run come in order, none left out.
  std::string frame_record(const RunFrame& frame, const Words& words = {});

 private:
  void write_words(const Words& words, bool first, RecordText& record);

  const PageDetail detail_;
  RowCoder rows_;
  Words words_;  ///< of the frame before
};

}  // namespace opal
