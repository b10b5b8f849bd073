#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace opal::ab {

/// What became of one cell.
struct CellResult {
  std::size_t number = 0;  ///< of the cell, see CellPlan
  std::string input;       ///< digest of what the arm was given: map, log, laser, window, hypotheses to judge
  std::map<std::string, double> values;  ///< by name of the metric; what was never reached is absent
  std::map<std::string, double> costs;   ///< measured, and so never twice the same: times, memory
  std::string failure;                   ///< empty: it ran; else what happened, "crashed: signal 11 (SIGSEGV)"
};

/// Finished cells of one worker, a line of JSON each, with a checksum; a line is on the disk before the next cell
/// begins.
class Journal {
 public:
  /// Goes on after the last whole line of the file. @throws Error naming it.
  explicit Journal(const std::string& path);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// @throws Error if the disk is full.
  void append(const CellResult& result);

 private:
  std::string path_;
  int file_ = -1;
};

/// Where a line stands.
struct JournalPlace {
  std::uint64_t offset = 0;
  std::uint32_t length = 0;
};

/// Reads a journal line by line. A last line that is not whole is what a killed worker leaves, and is not there.
/// @throws Error naming file and line if any other line is damaged.
void read_journal(const std::string& path, const std::function<void(const CellResult&, JournalPlace)>& take);

/// One line, without its end.
std::string journal_line(const CellResult& result);
/// @throws Error naming `place`.
CellResult parse_journal_line(const std::string& line, const std::string& place);

}  // namespace opal::ab
