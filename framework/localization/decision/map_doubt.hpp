#pragma once

#include <opal/common/export.hpp>

#include <string>

namespace opal {

/// Notices a map that does not explain what the robot sees, whichever place is the best: another building's map,
/// another storey's, or a poor one. It looks at the whole drive: each place that a search finds fits what was seen
/// last, or it would not have been found.
///
/// There is a doubt once no place has been localized for as much evidence as a status ever asks for, while many beams
/// pass through mapped surfaces. Where places look alike, none is localized either, but the beams agree. The doubt ends
/// when a place has been localized for as long.
class OPAL_EXPORT MapDoubt {
 public:
  /// @param most_weight  as StatusOptions::localized_most_weight, in pieces of evidence.
  explicit MapDoubt(double most_weight) : most_weight_(most_weight) {}

  /// @param agreeing      of the beams that the map speaks about, the share that ended on it lately.
  /// @param weight        how much of a new piece of evidence the newest scan was, in (0, 1].
  /// @param is_localized  the best place is called localized.
  void add(double agreeing, double weight, bool is_localized);
  void clear();

  bool stands() const { return stands_; }
  /// The doubt as a sentence; empty: there is none.
  std::string words() const;

 private:
  double most_weight_;
  double agreeing_ = 1;
  double found_ = 0, unfound_ = 0;  ///< evidence since a place is localized, or since none is
  double searched_ = 0;             ///< the longest that none was, since the doubt stands
  bool stands_ = false;
};

}  // namespace opal
