#pragma once

#include "review/decisions.hpp"

#include <opal/map/semantic_map.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal {

/// What is under review.
struct ReviewMatter {
  std::shared_ptr<const SemanticMap> map;
  Learned learned;
  std::string sensor;           ///< id; perceives what is added, and does not perceive any more what is gone
  std::string map_digest;       ///< of the map's contents
  std::string evidence_digest;  ///< of the contents of all drives
  double least_probability = kLeastProbability;  ///< proposals that are less probable are shown as doubtful
};

/// Proposals, and what a person has said of them.
class Review {
 public:
  explicit Review(ReviewMatter matter);

  /// Goes on with earlier decisions. Those that fit no proposal stay in the document, for the case that the evidence
  /// comes back; what they were about is asked again.
  /// @param file  that they were in. @throws ConfigError if they are about another map.
  /// @return what has changed since, in sentences.
  std::vector<std::string> resume(Decisions earlier, const std::string& file);

  /// Takes decisions, all or none of them; each is about a proposal, and replaces what was said of it before.
  /// @param source  where they come from, for messages. @throws ConfigError if one is about anything else.
  void take(const Decisions& more, const std::string& source);

  const ReviewMatter& matter() const { return matter_; }
  const std::vector<Subject>& subjects() const { return subjects_; }  ///< of the proposals, in their order
  /// What was said of a proposal; null: nothing.
  const Decision* decision_on(std::size_t proposal) const;
  const Decisions& decisions() const { return decisions_; }
  /// Exactly the accepted proposals, as a document (docs/overlays.md).
  nlohmann::ordered_json overlay() const;
  /// "3 of 12 decided, 2 accepted".
  std::string count() const;

 private:
  std::optional<std::size_t> proposal_of(const Subject& subject) const;

  ReviewMatter matter_;
  std::vector<Subject> subjects_;
  Decisions decisions_;
};

/// Where the results of a review are kept.
struct ReviewFiles {
  std::string decisions, overlay;
};

/// Writes the decisions first, then the overlay, each whole or not at all. @throws WriteError naming the file.
void save(const Review& review, const ReviewFiles& files);

}  // namespace opal
