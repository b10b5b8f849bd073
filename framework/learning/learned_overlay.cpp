#include "learning/learned_overlay.hpp"

#include "learning/prior_shares.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace opal {
namespace {

// Two visits that see one thing at places farther apart than this, and three sigma, do not agree.
constexpr double kOnePlace_m = 0.1;
constexpr double kSeenThrough = 0.3;

/// How often a visit is right about an object: it may have taken something before it for it, however long it looked.
double reliability(double keyframes) { return std::min(0.98, 1 - 0.5 * std::exp(-keyframes / 3.0)); }

/// What is gone is never recognized: it is looked for. What stands before an object may be taken for it, but lets no
/// beam through, so each look counts in full.
double reliability_of(const Deviation& deviation) {
  return deviation.verdict == DeviationVerdict::probably_absent ? reliability(3 * deviation.looks)
                                                                : reliability(deviation.observations);
}

struct Visit {
  const Deviation* deviation;
  const std::string* drive;
};

/// How likely visits are to say what they say of an object that is as mapped, moved, gone: each is right as often as
/// `reliability` says, and else says one of the others.
VerdictLikelihood likelihood(const std::vector<Visit>& visits) {
  VerdictLikelihood likely{1, 1, 1};
  for (const Visit& visit : visits) {
    const double right = reliability_of(*visit.deviation);
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      likely[k] *= static_cast<int>(visit.deviation->verdict) == k ? right : (1 - right) / 2;
      sum += likely[k];
    }
    for (double& each : likely) each /= sum;
  }
  return likely;
}

/// The most probable verdict of those that some visit has given; else the object is as mapped.
DeviationVerdict best_verdict(const std::array<double, 3>& probability, const std::vector<Visit>& visits) {
  auto best = DeviationVerdict::as_mapped;
  for (const Visit& visit : visits)
    if (probability[static_cast<std::size_t>(visit.deviation->verdict)] > probability[static_cast<std::size_t>(best)])
      best = visit.deviation->verdict;
  return best;
}

/// Bayes' rule.
std::array<double, 3> posterior(const VerdictLikelihood& prior, const VerdictLikelihood& likely) {
  std::array<double, 3> probability{};
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += probability[k] = prior[k] * likely[k];
  for (double& each : probability) each /= sum;
  return probability;
}

void name_drives(Proposal& proposal, const std::set<std::string>& drives) {
  proposal.drives.assign(drives.begin(), drives.end());
}

/// Where visits have seen a moved object: their mean by information. Conflicting if one of them is far from it.
void place(Proposal& proposal, const std::vector<Visit>& visits) {
  double information = 0;
  Point pull = Point::Zero();
  for (const Visit& visit : visits) {
    if (visit.deviation->verdict != DeviationVerdict::moved) continue;
    const double weight = 1 / std::max(1e-6, visit.deviation->sigma_m * visit.deviation->sigma_m);
    information += weight;
    pull += weight * visit.deviation->moved;
  }
  proposal.moved = pull / information;
  proposal.sigma_m = 1 / std::sqrt(information);
  for (const Visit& visit : visits) {
    const double off_m = (visit.deviation->moved - proposal.moved).norm();
    if (visit.deviation->verdict == DeviationVerdict::moved && visit.deviation->faces.empty() &&
        off_m > std::max(kOnePlace_m, 3 * visit.deviation->sigma_m))
      proposal.is_conflicting = true;
  }
}

/// Where visits have seen each face of a moved object. Conflicting if one of them is far from the mean.
void place_faces(Proposal& proposal, const std::vector<Visit>& visits) {
  struct Sum {
    double information = 0, pull = 0;
  };
  std::map<std::string, Sum> sums;
  const auto weight = [](const FaceOffset& face) { return 1 / std::max(1e-6, face.sigma_m * face.sigma_m); };
  for (const Visit& visit : visits)
    for (const FaceOffset& face : visit.deviation->faces) {
      sums[face.face].information += weight(face);
      sums[face.face].pull += weight(face) * face.offset_m;
    }
  for (const auto& [face, sum] : sums) proposal.face_offsets[face] = sum.pull / sum.information;
  for (const Visit& visit : visits)
    for (const FaceOffset& face : visit.deviation->faces)
      if (std::abs(face.offset_m - proposal.face_offsets.at(face.face)) > std::max(kOnePlace_m, 3 * face.sigma_m))
        proposal.is_conflicting = true;
}

VisitSight sight_of(const Visit& visit, bool agrees) {
  VisitSight sight{*visit.drive, agrees, visit.deviation->observations, visit.deviation->verdict};
  sight.moved = visit.deviation->moved;
  sight.sigma_m = visit.deviation->sigma_m;
  sight.seen_through_share = visit.deviation->seen_through_share;
  return sight;
}

Proposal proposal_for(const MapObject& object, const std::vector<Visit>& visits, DeviationVerdict verdict,
                      double probability) {
  Proposal proposal{object.id, object.type};
  proposal.change = verdict == DeviationVerdict::moved ? Change::moved : Change::gone;
  proposal.probability = probability;
  std::set<std::string> drives;
  bool was_there = false, was_away = false;
  for (const Visit& visit : visits) {
    const bool agrees = visit.deviation->verdict == verdict;
    ++(agrees ? proposal.visits_for : proposal.visits_against);
    if (agrees) drives.insert(*visit.drive);
    (visit.deviation->verdict == DeviationVerdict::probably_absent ? was_away : was_there) = true;
    proposal.sights.push_back(sight_of(visit, agrees));
  }
  proposal.moves_about = was_there && was_away;
  if (proposal.change == Change::moved) {
    place(proposal, visits);
    place_faces(proposal, visits);
  }
  name_drives(proposal, drives);
  return proposal;
}

struct FaceSight {
  const std::string* drive;
  const VisitEvidence* visit;
  UnmappedFace face;
};

/// The same unmapped face on several visits: the view that most keyframes have.
struct FaceGroup {
  UnmappedFace best;
  std::vector<FaceSight> seen = {};  ///< a visit may see it in pieces: the best seen one counts

  /// All of one visit one after the other.
  void add(const DriveEvidence& drive, const VisitEvidence& visit, const UnmappedFace& face) {
    if (face.views > best.views) best = face;
    if (seen.empty() || seen.back().visit != &visit) seen.push_back({&drive.drive, &visit, face});
    if (face.views > seen.back().face.views) seen.back().face = face;
  }
};

bool is_same_face(const Segment& a, const Segment& b) {
  constexpr double kTurn_rad = 0.15, kOff_m = 0.2;
  const Segment& longer = a.length_m() < b.length_m() ? b : a;
  const Segment& shorter = a.length_m() < b.length_m() ? a : b;
  return std::abs(wrap_angle(a.heading_rad() - b.heading_rad())) < kTurn_rad &&
         std::abs(longer.normal().dot(shorter.midpoint() - longer.begin)) < kOff_m &&
         distance_m(longer, shorter.midpoint()) < kOff_m;
}

std::vector<FaceGroup> grouped_faces(const std::vector<const DriveEvidence*>& drives) {
  std::vector<FaceGroup> groups;
  for (const DriveEvidence* drive : drives)
    for (const VisitEvidence& visit : drive->visits)
      for (const UnmappedFace& face : visit.unmapped) {
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const FaceGroup& each) { return is_same_face(each.best.face, face.face); });
        if (group == groups.end()) group = groups.insert(groups.end(), FaceGroup{face});
        group->add(*drive, visit, face);
      }
  return groups;
}

std::string name_of_addition(std::size_t number) { return "learned-" + std::to_string(number); }

bool stands(const FaceSight& sight) { return sight.face.seen_through_share < kSeenThrough; }

/// How much likelier visits are to say what they say if the face stands there for good [nat].
double log_odds_of(const FaceGroup& group) {
  double sum = 0;
  for (const FaceSight& sight : group.seen) {
    const double right = log_odds(reliability(sight.face.views));
    sum += stands(sight) ? right : -right;
  }
  return sum;
}

Proposal proposal_for(const FaceGroup& group, double prior, std::size_t number) {
  Proposal proposal{name_of_addition(number), "opal:Wall", Change::added};
  proposal.face = group.best.face;
  std::set<std::string> drives;
  for (const FaceSight& sight : group.seen) {
    const auto& [drive, visit, face] = sight;
    const bool agrees = stands(sight);
    ++(agrees ? proposal.visits_for : proposal.visits_against);
    drives.insert(*drive);
    proposal.sights.push_back({.drive = *drive,
                               .agrees = agrees,
                               .keyframes = face.views,
                               .face = face.face,
                               .seen_through_share = face.seen_through_share});
  }
  proposal.probability = probability_of(log_odds(prior) + log_odds_of(group));
  proposal.moves_about = proposal.visits_against > 0;
  name_drives(proposal, drives);
  return proposal;
}

/// @param names  of what is on the map.
void propose_additions(Learned& learned, const std::vector<FaceGroup>& groups, const std::set<std::string>& names) {
  std::vector<double> seen_again;
  for (const FaceGroup& group : groups)
    if (group.seen.size() > 1) seen_again.push_back(log_odds_of(group));
  const double prior = prior_share_of_additions(seen_again);
  std::size_t number = 0;
  for (const FaceGroup& group : groups) {
    do ++number;
    while (names.contains(name_of_addition(number)));
    learned.proposals.push_back(proposal_for(group, prior, number));
  }
}

/// Each once, in an order that only their contents decide.
std::vector<const DriveEvidence*> in_order(std::span<const DriveEvidence> drives) {
  std::map<std::string, const DriveEvidence*> by_text;
  for (const DriveEvidence& drive : drives) by_text.emplace(drive.drive + '\n' + to_json(drive).dump(), &drive);
  std::vector<const DriveEvidence*> ordered;
  for (const auto& [text, drive] : by_text) ordered.push_back(drive);
  return ordered;
}

bool is_first(const Proposal& a, const Proposal& b) {
  return a.probability != b.probability ? a.probability > b.probability : a.id < b.id;
}

}  // namespace

const MapObject* object_of(const SemanticMap& map, const Proposal& proposal) {
  for (const MapObject& object : map.objects())
    if (object.id == proposal.id) return &object;
  return nullptr;
}

Learned learned_from(const SemanticMap& map, std::span<const DriveEvidence> drives) {
  const std::vector<const DriveEvidence*> ordered = in_order(drives);
  std::map<std::string, std::vector<Visit>> by_object;
  for (const DriveEvidence* drive : ordered)
    for (const VisitEvidence& visit : drive->visits)
      for (const Deviation& deviation : visit.objects)
        by_object[deviation.object].push_back({&deviation, &drive->drive});
  std::vector<VerdictLikelihood> likely;
  for (const MapObject& object : map.objects())
    if (const auto visits = by_object.find(object.id); visits != by_object.end())
      likely.push_back(likelihood(visits->second));
  const VerdictLikelihood prior = prior_shares(likely);
  Learned learned;
  std::set<std::string> names;
  for (const MapObject& object : map.objects()) {
    names.insert(object.id);
    const auto visits = by_object.find(object.id);
    if (visits == by_object.end()) {
      ++learned.unseen;
      continue;
    }
    const std::array<double, 3> probability = posterior(prior, likelihood(visits->second));
    const DeviationVerdict best = best_verdict(probability, visits->second);
    if (best == DeviationVerdict::as_mapped)
      ++learned.sound;
    else
      learned.proposals.push_back(
          proposal_for(object, visits->second, best, probability[static_cast<std::size_t>(best)]));
  }
  propose_additions(learned, grouped_faces(ordered), names);
  std::stable_sort(learned.proposals.begin(), learned.proposals.end(), is_first);
  return learned;
}

}  // namespace opal
