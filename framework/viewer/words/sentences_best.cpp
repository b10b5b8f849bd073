#include "common/phrases.hpp"
#include "report/quantity_text.hpp"
#include "report/status_text.hpp"
#include "viewer/reading/id_format.hpp"
#include "viewer/words/sentences.hpp"

#include <opal/map/object_words.hpp>
#include "localization/alignment/registration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace opal {
namespace {

constexpr std::size_t kNamedObjects = 4, kNamedLocals = 8, kFindingsOfBest = 2;

std::string name_of_object(const RunHeader& header, const RunHeader::Feature& feature) {
  if (!feature.object.exists()) return object_words(feature.type, feature.id, "", false);
  const RunHeader::Object& object = header.object(feature.object);
  return object_words(object.type, object.id, object.name, object.name_is_shared);
}

class Support {
 public:
  Support(const ExplainedMoment& moment, const TracedHypothesis& best)
      : header_(moment.header), T_map_local_(best.T_map_base * moment.state.frame().T_local_base.inverse()) {
    const auto& locals = moment.state.local_features();
    for (const Association& pair : best.pairs) {
      const auto local = locals.find(pair.local_feature);
      if (local == locals.end()) continue;
      if (pair.map_feature.exists())
        see(local->second, pair.map_feature);
      else
        not_on_map_.insert(pair.local_feature);
    }
  }

  void add_to(std::vector<Sentence>& sentences) const {
    if (pairs_ > 0)
      sentences.push_back({SentenceKind::support, "rests on " + count_of(pairs_, "association") + " with " +
                                                      count_of(nearest_m_.size(), "object") + ": " + objects()});
  }

  void add_unmapped_to(std::vector<Sentence>& sentences) const {
    if (not_on_map_.empty()) return;
    sentences.push_back({SentenceKind::note, "takes " + count_of(not_on_map_.size(), "local feature") +
                                                 " for not on the map: " + listed(not_on_map_, "", kNamedLocals)});
  }

 private:
  void see(const RecordedLocalFeature& local, MapFeatureNumber mapped) {
    const RunHeader::Feature& feature = header_.feature(mapped);
    if (kind_of(feature.geometry) != kind_of(local.geometry)) return;
    const Geometry placed = transformed(T_map_local_, local.geometry);
    const double off_m = mismatch(placed, feature.geometry).position_m;
    const auto [entry, added] = nearest_m_.try_emplace(name_of_object(header_, feature), off_m);
    entry->second = std::min(entry->second, off_m);
    ++pairs_;
  }

  std::string objects() const {
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, off_m] : nearest_m_) order.emplace_back(off_m, name);
    std::sort(order.begin(), order.end());
    std::vector<std::string> names;
    for (const auto& [off_m, name] : order) names.push_back(name + " (" + metres_text(off_m) + ")");
    return listed(names, "", kNamedObjects);
  }

  const RunHeader& header_;
  Pose2 T_map_local_;
  std::size_t pairs_ = 0;
  std::map<std::string, double> nearest_m_;  ///< per object
  std::set<LocalFeatureId> not_on_map_;
};

/// Empty if its spawn is not recorded.
std::string origin_text(const TracedHypothesis& hypothesis) {
  if (!hypothesis.parent.exists() && hypothesis.origin.empty()) return {};
  std::string text =
      hypothesis.parent.exists() ? fmt::format("branched from hypothesis {}", hypothesis.parent) : "spawned";
  text += " at " + seconds_text(hypothesis.spawned_s);
  return hypothesis.origin.empty() ? text : text + " from " + hypothesis.origin;
}

/// "on Third floor of GDC, there at (1.0, 2.0) m: "; empty if the map holds no storeys.
std::string storey_text(const RunHeader& header, const Pose2& T_map_base) {
  const RunHeader::Storey* storey = header.storey_at(T_map_base.position());
  if (storey == nullptr) return "";
  return fmt::format("on {}, there at {}; on the map ", storey->name,
                     place_text(T_map_base.position() - storey->origin));
}

}  // namespace

void add_answer(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  const RunFrame& frame = moment.state.frame();
  const TracedHypothesis* best = moment.state.best();
  std::string text =
      status_text(frame.status, best ? frame.probability : 0) + " since " + seconds_text(moment.status_since_s) + ": ";
  if (best)
    text += fmt::format("{}at {}, with probability {} (hypothesis {}, {} alive)",
                        storey_text(moment.header, best->T_map_base), pose_text(best->T_map_base),
                        probability_text(frame.probability), best->id, frame.hypotheses.size());
  else
    text += "no hypothesis is alive";
  text += "; \"none of these\" has " + probability_text(frame.none);
  sentences.push_back({SentenceKind::answer, text});
  if (const std::string reason = reason_text(frame.status, frame.why, frame.sensor); best && !reason.empty())
    sentences.push_back({SentenceKind::answer, reason});
}

void add_support(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  const TracedHypothesis* best = moment.state.best();
  if (!best) return;
  Support(moment, *best).add_to(sentences);
  if (const std::string origin = origin_text(*best); !origin.empty())
    sentences.push_back({SentenceKind::support, origin});
}

void add_unmapped(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  if (const TracedHypothesis* best = moment.state.best()) Support(moment, *best).add_unmapped_to(sentences);
}

void add_findings(const ExplainedMoment& moment, std::vector<Sentence>& sentences) {
  const TracedHypothesis* best = moment.state.best();
  if (!best) return;
  if (best->scan_nat < 0)
    sentences.push_back({SentenceKind::against, "the newest scan scores " + nat_text(best->scan_nat)});
  const std::string text = findings_text(moment.state.frame().findings, kFindingsOfBest);
  if (!text.empty()) sentences.push_back({SentenceKind::against, text});
}

}  // namespace opal
