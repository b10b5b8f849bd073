#pragma once

#include "review/review.hpp"
#include "tests/learning/made_drives.hpp"

namespace opal::made {

/// One drive of two visits' worth: a wall that moved, one that is gone, a face that the map lacks; wall-3 is in
/// conflict.
inline std::vector<DriveEvidence> drives(double moved_m = 0.4) {
  const auto one = [&](const std::string& name, double where_m) {
    return drive(name,
                 {seen("wall-0", kMoved, {0, moved_m}), seen("wall-2", kGone), seen("wall-3", kMoved, {where_m, 0})},
                 {{{{2, 3}, {5, 3}}, 10, 0}});
  };
  return {one("monday", 0.6), one("tuesday", -0.5)};
}

inline ReviewMatter matter(const std::vector<DriveEvidence>& evidence, const std::string& digest = "e1") {
  const auto map = room();
  return {map, learned_from(*map, evidence), kSensor, "m1", digest};
}

inline std::size_t number_of(const Review& review, const std::string& id) {
  for (std::size_t k = 0; k < review.subjects().size(); ++k)
    if (review.subjects()[k].id == id) return k;
  throw std::runtime_error("no proposal " + id);
}

inline Answer answer_on(const Review& review, const std::string& id) {
  const Decision* decision = review.decision_on(number_of(review, id));
  return decision ? decision->answer : Answer::undecided;
}

/// A document that says this of proposals, as the page would send it.
inline Decisions said(const Review& review, const std::vector<std::pair<std::string, Answer>>& answers) {
  Decisions decisions{"room", "m1", "e1"};
  for (const auto& [id, answer] : answers) decisions.all.push_back({review.subjects()[number_of(review, id)], answer});
  return decisions;
}

}  // namespace opal::made
