#pragma once

#include "viewer/encoding/page_encoder.hpp"
#include "viewer/reading/run_reader.hpp"

#include <functional>
#include <string>
#include <vector>

namespace opal {

/// Says what there is to say about the newest frame; it is called with the frames of a run in order.
using Narrator = std::function<Words(const RunHeader&, const RunFrame&)>;
/// Makes a narrator that knows nothing yet: a run may be read more than once.
using MakeNarrator = std::function<Narrator()>;

/// A run as it stands in the page.
struct PackedRun {
  std::string name;  ///< what the page calls it
  std::string data;  ///< base64 of gzip of records
  std::size_t frames = 0;
  std::vector<std::string> notes;    ///< of the reader: what is missing at the end
  std::vector<std::string> reduced;  ///< what was left out to keep it small
};

/// Packs a run with as much detail as fits. A run that is too long even for the least detail is packed with
/// that.
/// @param out  as for event_file. @param name  what the page calls it. @param limit  characters of data.
/// @throws EventError as read_run; also if the run has no update.
PackedRun pack_run(const std::string& out, const std::string& name, std::size_t limit,
                   const MakeNarrator& make_narrator);

}  // namespace opal
