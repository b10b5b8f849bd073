#include "review/review.hpp"

#include "common/text_file.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace opal {
namespace {

/// A later decision replaces an earlier one about the same, and what was said of the same object otherwise.
bool replaces(const Subject& later, const Subject& earlier) {
  const bool is_mapped = later.change != Change::added && earlier.change != Change::added;
  return is_same(later, earlier) || (is_mapped && later.id == earlier.id);
}

std::string what_changed(const Decisions& earlier, const ReviewMatter& matter) {
  const bool map = earlier.map_digest != matter.map_digest,
             evidence = earlier.evidence_digest != matter.evidence_digest;
  if (map && evidence) return "the map and the evidence have changed";
  if (map) return "the map has changed";
  return evidence ? "the evidence has changed" : "";
}

}  // namespace

Review::Review(ReviewMatter matter) : matter_(std::move(matter)) {
  for (const Proposal& proposal : matter_.learned.proposals) subjects_.push_back(subject_of(*matter_.map, proposal));
  decisions_ = {matter_.map->name(), matter_.map_digest, matter_.evidence_digest};
}

std::vector<std::string> Review::resume(Decisions earlier, const std::string& file) {
  if (earlier.map != matter_.map->name())
    throw ConfigError(file + ": /map: \"" + earlier.map + "\", expected \"" + matter_.map->name() + "\"");
  std::vector<std::string> notes, asked_again;
  for (const Decision& decision : earlier.all)
    if (decision.answer != Answer::undecided && !proposal_of(decision.about))
      asked_again.push_back(
          fmt::format("{} {} was {}", name_of(decision.about.change), decision.about.id, name_of(decision.answer)));
  const std::string cause = what_changed(earlier, matter_);
  if (!cause.empty() || !asked_again.empty())
    notes.push_back(fmt::format("{}: {}; {} of {} decisions hold as they are", file,
                                cause.empty() ? "some decisions fit no proposal" : "since then " + cause,
                                earlier.all.size() - asked_again.size(), earlier.all.size()));
  for (const std::string& each : asked_again)
    notes.push_back(each + "; this is not what drives say of this map now, so look again");
  decisions_.all = std::move(earlier.all);
  return notes;
}

void Review::take(const Decisions& more, const std::string& source) {
  for (std::size_t k = 0; k < more.all.size(); ++k)
    if (!proposal_of(more.all[k].about))
      throw ConfigError(fmt::format("{}: /decisions/{}/about: {}, expected one of the {} proposals", source, k,
                                    to_json(more.all[k].about).dump(), subjects_.size()));
  for (const Decision& decision : more.all) {
    std::erase_if(decisions_.all, [&](const Decision& each) { return replaces(decision.about, each.about); });
    if (decision.answer != Answer::undecided) decisions_.all.push_back(decision);
  }
}

std::optional<std::size_t> Review::proposal_of(const Subject& subject) const {
  const auto at = std::ranges::find_if(subjects_, [&](const Subject& each) { return is_same(each, subject); });
  if (at == subjects_.end()) return std::nullopt;
  return at - subjects_.begin();
}

const Decision* Review::decision_on(std::size_t proposal) const {
  const auto at = std::find_if(decisions_.all.rbegin(), decisions_.all.rend(),
                               [&](const Decision& each) { return is_same(each.about, subjects_[proposal]); });
  return at == decisions_.all.rend() ? nullptr : &*at;
}

nlohmann::ordered_json Review::overlay() const {
  std::set<const Proposal*> accepted;
  for (std::size_t k = 0; k < subjects_.size(); ++k)
    if (const Decision* decision = decision_on(k); decision && decision->answer == Answer::accepted)
      accepted.insert(&matter_.learned.proposals[k]);
  return overlay_of(*matter_.map, matter_.learned, matter_.sensor,
                    [&](const Proposal& proposal) { return accepted.contains(&proposal); });
}

std::string Review::count() const {
  std::size_t decided = 0, accepted = 0;
  for (std::size_t k = 0; k < subjects_.size(); ++k) {
    const Decision* decision = decision_on(k);
    decided += decision && decision->answer != Answer::undecided;
    accepted += decision && decision->answer == Answer::accepted;
  }
  return fmt::format("{} of {} decided, {} accepted", decided, subjects_.size(), accepted);
}

void save(const Review& review, const ReviewFiles& files) {
  write_text(files.decisions, to_json(review.decisions()).dump(1) + '\n');
  write_text(files.overlay, review.overlay().dump(1) + '\n');
}

}  // namespace opal
