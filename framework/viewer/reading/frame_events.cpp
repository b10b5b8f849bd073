#include "viewer/reading/frame_events.hpp"

#include <algorithm>
#include <map>

namespace opal {
namespace {

HypothesisId optional_hypothesis(const EventPlace& event, const char* name) {
  const auto found = event.find(name);
  return found ? found->id_or_none<HypothesisId>() : HypothesisId();
}

std::string optional_name(const EventPlace& event, const char* name) {
  const auto found = event.find(name);
  return found ? found->name() : "";
}

double optional_nat(const EventPlace& event, const char* name) {
  const auto found = event.find(name);
  return found ? found->nat() : EventPlace::kWorst_nat;
}

std::vector<Point> optional_points(const EventPlace& event, const char* name) {
  const auto found = event.find(name);
  return found ? found->points() : std::vector<Point>{};
}

std::vector<Association> read_pairs(const EventPlace& event, const FeaturePositions& features) {
  std::vector<Association> pairs;
  const auto array = event.find("pairs");
  if (!array) return pairs;
  for (std::size_t k = 0; k < array->elements(); ++k) {
    const EventPlace pair = array->element(k);
    if (pair.elements() != 2) pair.fail("[local feature, mapped feature or null]");
    const EventPlace mapped = pair.element(1);
    pairs.push_back({pair.element(0).id_or_none<LocalFeatureId>(),
                     mapped.is_null() ? MapFeatureNumber() : mapped_feature(mapped, features)});
  }
  return pairs;
}

/// {scorer: {term: number}}; terms that are no number are left out.
std::vector<RecordedTerm> read_scores(const EventPlace& event) {
  std::vector<RecordedTerm> terms;
  const auto scores = event.find("scores");
  if (!scores) return terms;
  scores->for_each_member([&](const std::string& scorer, const EventPlace& place) {
    place.for_each_member([&](const std::string& term, const EventPlace& value) {
      if (!value.is_null()) terms.push_back({scorer, term, value.nat()});
    });
  });
  return terms;
}

std::vector<RecordedFinding> read_findings(const EventPlace& event, const FeaturePositions& features) {
  std::vector<RecordedFinding> findings;
  const auto array = event.find("findings");
  if (!array) return findings;
  for (std::size_t k = 0; k < array->elements(); ++k) {
    const EventPlace place = array->element(k);
    RecordedFinding finding{
        place.member("scorer").name(), place.member("words").sentence(), {}, optional_points(place, "line")};
    if (!finding.line.empty() && finding.line.size() != 2) place.member("line").fail("[x, y, x, y]");
    if (const auto mapped = place.find("map_feature")) finding.map_feature = mapped_feature(*mapped, features);
    findings.push_back(std::move(finding));
  }
  return findings;
}

// ---------------------------------------------------------------------------------------------- kinds of
// events

void read_keyframe(const EventPlace& event, const FeaturePositions&, RunFrame& frame) {
  frame.keyframe = event.member("keyframe").id<KeyframeId>();
  frame.stamp_s = event.member("stamp_s").stamp_s();
  frame.T_local_base = event.member("T_local_base").pose();
  if (const auto match = event.find("scan_match")) frame.scan_match = match->flag();
  frame.scan = optional_points(event, "scan");
  frame.free_space = optional_points(event, "free_space");
}

void read_local_features(const EventPlace& event, const FeaturePositions&, RunFrame& frame) {
  if (const auto changed = event.find("changed"))
    for (std::size_t k = 0; k < changed->elements(); ++k) {
      const EventPlace place = changed->element(k);
      frame.changed.push_back({place.member("id").id<LocalFeatureId>(), place.member("type").name(),
                               place.member("stable").flag(), place.member("measurements").count(), place.geometry()});
    }
  if (const auto gone = event.find("gone"))
    for (const LocalFeatureId id : gone->ids<LocalFeatureId>()) frame.gone.push_back(id);
}

void read_pruned(const EventPlace& event, const FeaturePositions& features, RunFrame& frame) {
  RecordedEnd end;
  end.id = event.member("hypothesis").id<HypothesisId>();
  end.reason = event.member("reason").sentence();
  end.merged_into = optional_hypothesis(event, "merged_into");
  end.T_map_base = event.member("T_map_base").pose();
  end.log_likelihood = optional_nat(event, "log_likelihood");
  end.scan_nat = optional_nat(event, "scan_nat");
  end.scores = read_scores(event);
  end.findings = read_findings(event, features);
  frame.ends.push_back(std::move(end));
}

/// The template of a pattern; else what "origin" says, in words where no other field tells it.
std::string origin_of(const EventPlace& event) {
  std::string pattern_template = optional_name(event, "template");
  if (!pattern_template.empty()) return pattern_template;
  const std::string origin = optional_name(event, "origin");
  if (origin == "hint") return "a hint";
  return origin == "other_storey" ? "another storey" : "";
}

void read_searched(const EventPlace& event, const FeaturePositions& features, RunFrame& frame) {
  RecordedSearch& search = frame.search.emplace();
  if (const auto patterns = event.find("patterns"))
    for (std::size_t k = 0; k < patterns->elements(); ++k) {
      const EventPlace place = patterns->element(k);
      search.patterns.push_back({place.member("template").name(), place.member("local_features").ids<LocalFeatureId>(),
                                 place.member("candidates").count()});
    }
  const auto proposed = event.find("proposed");
  search.proposed = proposed ? proposed->count() : 0;
  if (const auto rejected = event.find("rejected"))
    for (std::size_t k = 0; k < rejected->elements(); ++k) {
      const EventPlace place = rejected->element(k);
      search.rejected.push_back({origin_of(place), place.member("T_map_base").pose(), read_pairs(place, features),
                                 optional_nat(place, "nat"), place.member("reason").sentence()});
    }
}

void read_spawned(const EventPlace& event, const FeaturePositions& features, RunFrame& frame) {
  frame.spawns.push_back({event.member("hypothesis").id<HypothesisId>(), optional_hypothesis(event, "parent"),
                          origin_of(event), event.member("T_map_base").pose(), optional_nat(event, "log_likelihood"),
                          read_pairs(event, features)});
}

void read_associated(const EventPlace& event, const FeaturePositions& features, RunFrame& frame) {
  frame.growths.push_back({event.member("hypothesis").id<HypothesisId>(), read_pairs(event, features)});
}

void read_dissociated(const EventPlace& event, const FeaturePositions&, RunFrame& frame) {
  frame.losses.push_back({event.member("hypothesis").id<HypothesisId>(),
                          event.member("local_features").ids<LocalFeatureId>(), event.member("reason").sentence()});
}

void read_rejected(const EventPlace& event, const FeaturePositions& features, RunFrame& frame) {
  frame.rejections.push_back(
      {event.member("hypothesis").id<HypothesisId>(), read_pairs(event, features), event.member("reason").sentence()});
}

RecordedHypothesis read_hypothesis(const EventPlace& place) {
  RecordedHypothesis hypothesis;
  hypothesis.id = place.member("hypothesis").id<HypothesisId>();
  hypothesis.T_map_base = place.member("T_map_base").pose();
  hypothesis.log_likelihood = place.member("log_likelihood").nat();
  hypothesis.scan_nat = optional_nat(place, "scan_nat");
  hypothesis.probability = place.member("probability").probability();
  hypothesis.scores = read_scores(place);
  return hypothesis;
}

void require_distinct(const EventPlace& array, const std::vector<RecordedHypothesis>& hypotheses) {
  std::vector<HypothesisId> ids;
  for (const RecordedHypothesis& hypothesis : hypotheses) ids.push_back(hypothesis.id);
  std::sort(ids.begin(), ids.end());
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end()) array.fail("each hypothesis once");
}

const std::string& read_status(const EventPlace& status) {
  for (const char* known : {"searching", "ambiguous", "localized", "lost"})
    if (status.name() == known) return status.name();
  status.fail("'searching', 'ambiguous', 'localized' or 'lost'");
}

void read_estimate(const EventPlace& event, const FeaturePositions& features, RunFrame& frame) {
  frame.status = read_status(event.member("status"));
  frame.probability = event.member("probability").probability();
  if (const auto none = event.find("none")) frame.none = none->probability();
  frame.why.clear();
  if (const auto why = event.find("why")) frame.why = why->sentence();
  frame.sensor.clear();
  if (const auto sensor = event.find("sensor"))
    for (std::size_t k = 0; k < sensor->elements(); ++k) frame.sensor.push_back(sensor->element(k).sentence());
  frame.best = optional_hypothesis(event, "hypothesis");
  const EventPlace array = event.member("hypotheses");
  frame.hypotheses.clear();
  frame.hypotheses.reserve(array.elements());
  for (std::size_t k = 0; k < array.elements(); ++k) frame.hypotheses.push_back(read_hypothesis(array.element(k)));
  require_distinct(array, frame.hypotheses);
  frame.findings = read_findings(event, features);
}

void read_cost(const EventPlace& event, const FeaturePositions&, RunFrame& frame) {
  constexpr double kLongest_ms = 1e9;
  frame.cpu_ms.clear();
  const auto cpu = event.find("cpu_ms");
  if (!cpu) return;
  cpu->for_each_member([&](const std::string& stage, const EventPlace& value) {
    frame.cpu_ms.emplace_back(stage, value.number(0, kLongest_ms));
  });
  std::stable_partition(frame.cpu_ms.begin(), frame.cpu_ms.end(),
                        [](const auto& stage) { return stage.first != "total"; });
}

using Reader = void (*)(const EventPlace&, const FeaturePositions&, RunFrame&);

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> kReaders{
      {"keyframe", read_keyframe},       {"local_features", read_local_features},
      {"pruned", read_pruned},           {"searched", read_searched},
      {"spawned", read_spawned},         {"associated", read_associated},
      {"dissociated", read_dissociated}, {"rejected", read_rejected},
      {"estimate", read_estimate},       {"cost", read_cost}};
  return kReaders;
}

}  // namespace

bool is_frame_event(const std::string& kind) { return readers().contains(kind); }

void read_frame_event(const std::string& kind, const EventPlace& event, const FeaturePositions& features,
                      RunFrame& frame) {
  readers().at(kind)(event, features, frame);
}

}  // namespace opal
