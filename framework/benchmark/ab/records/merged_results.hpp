#pragma once

#include "benchmark/ab/records/result_folder.hpp"

#include <fstream>
#include <functional>
#include <optional>

namespace opal::ab {

/// The finished cells of a folder by number, however many processes and machines have computed them. Of each, only
/// where it stands is kept in memory.
class MergedResults {
 public:
  /// @throws Error if a cell was computed twice and came out differently, or if two arms were given different inputs
  /// for the same task; names them.
  MergedResults(const ResultFolder& folder, const CellPlan& plan);

  std::size_t finished() const { return finished_; }
  bool complete() const { return finished_ == plan_.cells(); }
  /// All finished cells by number.
  void for_each(const std::function<void(const Cell&, const CellResult&)>& take) const;
  /// The same without tasks that some arm has not finished.
  void for_each_complete_task(const std::function<void(const Cell&, const CellResult&)>& take) const;

  /// Writes results.jsonl and times.jsonl: the former is the same to the byte for the same experiment, the latter
  /// never.
  /// @param arm_digests  of everything that the arms are made of, by arm.
  void write(const std::vector<std::string>& arm_digests) const;

 private:
  struct Place {
    std::uint64_t offset = 0;
    std::uint32_t length = 0;  ///< 0: not finished
    std::uint32_t journal = 0;
  };
  CellResult read(const Place& place) const;
  void add(std::uint32_t journal, const CellResult& result, const JournalPlace& place);
  void expect_equal_inputs() const;

  const ResultFolder& folder_;
  const CellPlan& plan_;
  std::vector<std::string> journals_;
  std::vector<Place> places_;  ///< by number
  std::size_t finished_ = 0;
  mutable std::ifstream open_file_;  ///< neighbours often stand in the same journal
  mutable std::optional<std::uint32_t> open_journal_;
};

}  // namespace opal::ab
