#pragma once

#include "learning/learned_overlay.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace opal {

enum class Answer { undecided, accepted, refused };
const char* name_of(Answer answer);

/// What a person decides about: what the map says, and what drives say instead. Proposals get other numbers when there
/// is other evidence, so it is known by its contents. Frame: `map`; all numbers are whole millimetres, in metres.
struct Subject {
  std::string id;  ///< of the proposal
  Change change = Change::moved;
  Point moved = Point::Zero();                   ///< of a moved object
  Segment face = {};                             ///< of something added
  std::vector<std::vector<double>> mapped = {};  ///< of an object of the map: the numbers of each of its geometries
  bool is_disputed = false;                      ///< visits contradict each other: it cannot be accepted
};

Subject subject_of(const SemanticMap& map, const Proposal& proposal);

/// Whether a decision about one is a decision about the other: the map says the same, and drives say the same within
/// 0.05 m, which is as much as a person sees in the picture.
bool is_same(const Subject& a, const Subject& b);

struct Decision {
  Subject about;
  Answer answer = Answer::undecided;
  std::string by = {};    ///< who decided; may be empty
  std::string at = {};    ///< when: "2026-01-31T10:00:00Z"; may be empty
  std::string note = {};  ///< may be empty
};

/// What a person has said of proposals. A document of its own, from which an overlay is made.
struct Decisions {
  std::string map;              ///< name
  std::string map_digest;       ///< of its contents
  std::string evidence_digest;  ///< of the contents of all drives
  std::vector<Decision> all = {};
};

nlohmann::ordered_json to_json(const Subject& subject);
nlohmann::ordered_json to_json(const Decisions& decisions);

/// @throws ConfigError naming file, place, what was found and what was expected.
Decisions decisions_from(const nlohmann::json& document, const std::string& file);

}  // namespace opal
