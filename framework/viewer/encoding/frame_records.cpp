#include "viewer/encoding/frame_records.hpp"

#include <algorithm>

namespace opal {
namespace {

constexpr int kMetreDecimals = 3, kPoseDecimals = 3, kAngleDecimals = 4, kNatDecimals = 2, kProbabilityDecimals = 4,
              kCpuDecimals = 3, kPathDecimals = 2;
constexpr double kShownProbability = 0.0005;

/// Kind and numbers, as elements or as one member.
struct WriteGeometry {
  RecordText& record;
  bool as_member;

  RecordText& named(const char* kind) const { return as_member ? record.key(kind).open('[') : record.text(kind); }
  RecordText& at(const Point& p) const { return record.number(p.x(), kMetreDecimals).number(p.y(), kMetreDecimals); }
  void done() const {
    if (as_member) record.close(']');
  }

  void operator()(const Point& p) const {
    named("point");
    at(p);
    done();
  }
  void operator()(const OrientedPoint& p) const {
    named("oriented_point");
    at(p.position).number(p.heading_rad, kAngleDecimals).number(p.opening_rad, kAngleDecimals);
    done();
  }
  void operator()(const Segment& s) const {
    named("segment");
    at(s.begin);
    at(s.end);
    done();
  }
  void operator()(const Circle& c) const {
    named("circle");
    at(c.center).number(c.radius_m, kMetreDecimals);
    done();
  }
};

void write_pairs(const std::vector<Association>& pairs, RecordText& record) {
  record.open('[');
  for (const Association& pair : pairs) record.open('[').id(pair.local_feature).id(pair.map_feature).close(']');
  record.close(']');
}

/// {scorer: {term: value}}; terms of one scorer follow each other.
void write_scores(const std::vector<RecordedTerm>& terms, RecordText& record) {
  record.open('{');
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const bool first = k == 0 || terms[k - 1].scorer != terms[k].scorer;
    const bool last = k + 1 == terms.size() || terms[k + 1].scorer != terms[k].scorer;
    if (first) record.key(terms[k].scorer).open('{');
    record.key(terms[k].term).number(terms[k].value, kNatDecimals);
    if (last) record.close('}');
  }
  record.close('}');
}

void write_findings(const std::vector<RecordedFinding>& findings, RecordText& record) {
  record.open('[');
  for (const RecordedFinding& finding : findings) {
    record.open('[').text(finding.scorer).text(finding.words).id(finding.map_feature).open('[');
    for (const Point& p : finding.line) record.number(p.x(), kMetreDecimals).number(p.y(), kMetreDecimals);
    record.close(']').close(']');
  }
  record.close(']');
}

/// Nothing if there are none, else `name: [one, one, ...]`.
template <class Item, class WriteOne>
void write_list(const char* name, const std::vector<Item>& items, RecordText& record, WriteOne write_one) {
  if (items.empty()) return;
  record.key(name).open('[');
  for (const Item& item : items) {
    record.open('[');
    write_one(item);
    record.close(']');
  }
  record.close(']');
}

}  // namespace

void write_mapped_feature(const RunHeader::Feature& feature, RecordText& record) {
  record.open('{').key("id").text(feature.id).key("object").id(feature.object);
  record.key("type").text(feature.type).key("perceivable").boolean(feature.perceivable);
  std::visit(WriteGeometry{record, true}, feature.geometry);
  record.close('}');
}

void write_local_features(const std::vector<RecordedLocalFeature>& changed, const std::vector<LocalFeatureId>& gone,
                          RecordText& record) {
  write_list("features", changed, record, [&](const RecordedLocalFeature& feature) {
    record.id(feature.id).text(feature.type).integer(feature.stable ? 1 : 0).integer(feature.measurements);
    std::visit(WriteGeometry{record, false}, feature.geometry);
  });
  if (!gone.empty()) record.key("gone").ids(gone);
}

std::vector<RecordedLocalFeature> features_of(const RunState& state) {
  std::vector<RecordedLocalFeature> features;
  for (const auto& [id, feature] : state.local_features()) features.push_back(feature);
  return features;
}

void write_restatement(const RunState& state, const ThinnedPath& path, RecordText& record) {
  record.key("restated").open('{').key("start").text(state.time_line()).key("hypotheses").open('[');
  for (const auto& [id, hypothesis] : state.alive()) {
    const bool has_parent = state.alive().contains(hypothesis.parent);
    record.open('[').id(id).id(has_parent ? hypothesis.parent : HypothesisId{}).text(hypothesis.origin);
    record.pose(hypothesis.T_map_base, kPoseDecimals).number(hypothesis.log_likelihood, kNatDecimals);
    write_pairs(hypothesis.pairs, record);
    record.close(']');
  }
  record.close(']').key("path").open('[');
  for (const std::vector<Point>& line : path.lines()) {
    record.open('[');
    for (const Point& p : line) record.number(p.x(), kPathDecimals).number(p.y(), kPathDecimals);
    record.close(']');
  }
  record.close(']').close('}');
}

void write_tree(const RunFrame& frame, RecordText& record) {
  write_list("spawned", frame.spawns, record, [&](const RecordedSpawn& spawn) {
    record.id(spawn.id).id(spawn.parent).text(spawn.origin).pose(spawn.T_map_base, kPoseDecimals);
    record.number(spawn.log_likelihood, kNatDecimals);
    write_pairs(spawn.pairs, record);
  });
  write_list("grown", frame.growths, record, [&](const RecordedGrowth& growth) {
    record.id(growth.hypothesis);
    write_pairs(growth.pairs, record);
  });
  write_list("lost", frame.losses, record,
             [&](const RecordedLoss& loss) { record.id(loss.hypothesis).ids(loss.local_features).text(loss.reason); });
  write_list("tried", frame.rejections, record, [&](const RecordedRejection& rejection) {
    record.id(rejection.hypothesis);
    write_pairs(rejection.pairs, record);
    record.text(rejection.reason);
  });
  write_list("ended", frame.ends, record, [&](const RecordedEnd& end) {
    record.id(end.id).text(end.reason).id(end.merged_into).pose(end.T_map_base, kPoseDecimals);
    record.number(end.log_likelihood, kNatDecimals).number(end.scan_nat, kNatDecimals);
    write_scores(end.scores, record);
    write_findings(end.findings, record);
  });
}

void write_search(const RecordedSearch& search, RecordText& record) {
  record.key("search").open('{').key("patterns").open('[');
  for (const auto& lookup : search.patterns)
    record.open('[').text(lookup.pattern_template).ids(lookup.local_features).integer(lookup.candidates).close(']');
  record.close(']').key("proposed").integer(search.proposed).key("rejected").open('[');
  for (const auto& rejected : search.rejected) {
    record.open('[').text(rejected.origin).pose(rejected.T_map_base, kPoseDecimals).number(rejected.nat, kNatDecimals);
    write_pairs(rejected.pairs, record);
    record.text(rejected.reason).close(']');
  }
  record.close(']').close('}');
}

void write_beliefs(std::span<const RecordedHypothesis> hypotheses, std::size_t most_scores, RecordText& record) {
  record.key("p").open('[');
  for (const RecordedHypothesis& hypothesis : hypotheses)
    if (hypothesis.probability > kShownProbability)
      record.open('[').id(hypothesis.id).number(hypothesis.probability, kProbabilityDecimals).close(']');
  record.close(']').key("scores").open('[');
  for (const RecordedHypothesis& hypothesis : hypotheses.first(std::min(most_scores, hypotheses.size()))) {
    record.open('[').id(hypothesis.id).number(hypothesis.scan_nat, kNatDecimals);
    write_scores(hypothesis.scores, record);
    record.close(']');
  }
  record.close(']');
}

void write_answer(const RunFrame& frame, RecordText& record) {
  record.key("status").text(frame.status);
  record.key("probability").number(frame.probability, kProbabilityDecimals);
  record.key("none").number(frame.none, kProbabilityDecimals).key("best").id(frame.best).key("findings");
  write_findings(frame.findings, record);
  if (frame.truth) record.key("truth").open('[').pose(*frame.truth, kPoseDecimals).close(']');
  record.key("cpu").open('{');
  for (const auto& [stage, ms] : frame.cpu_ms) record.key(stage).number(ms, kCpuDecimals);
  record.close('}');
}

}  // namespace opal
