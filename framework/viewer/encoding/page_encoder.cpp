#include "viewer/encoding/page_encoder.hpp"

#include "viewer/encoding/frame_records.hpp"

#include <algorithm>

namespace opal {
namespace {

/// Of the record's `local`, which rows are carried along with.
constexpr int kLocalDecimals = 4;

Pose2 as_written(const Pose2& pose) {
  return {rounded(pose.x(), kLocalDecimals), rounded(pose.y(), kLocalDecimals),
          rounded(pose.heading_rad(), kLocalDecimals)};
}

void write_moment(const RunFrame& frame, RecordText& record) {
  record.key("r").text("frame").key("keyframe").id(frame.keyframe);
  record.key("stamp").number(frame.stamp_s, 6).key("time").number(frame.time_s, 4);
  if (frame.starts) record.key("start").text(*frame.starts);
  record.key("local").open('[').pose(frame.T_local_base, kLocalDecimals).close(']');
  record.key("match").integer(frame.scan_match ? 1 : 0);
}

void write_scan(const RunFrame& frame, const PageDetail& detail, RecordText& record) {
  if (detail.scan_stride == 0) return;
  record.key("scan").points(frame.scan, detail.scan_unit_m, detail.scan_stride);
  record.key("free").points(frame.free_space, detail.scan_unit_m, detail.scan_stride);
}

void write_window(const KeptWindow& window, RecordText& record) {
  record.key("window").open('{');
  if (window.seconds) record.key("seconds").number(*window.seconds, 3);
  if (window.characters) record.key("characters").integer(static_cast<long long>(*window.characters));
  record.close('}');
}

void write_storeys(const RunHeader& header, RecordText& record) {
  record.key("storeys").open('[');
  for (const RunHeader::Storey& storey : header.storeys) {
    record.open('{').key("id").text(storey.id).key("name").text(storey.name).key("bounds").open('[');
    for (const Point& corner : storey.bounds) record.number(corner.x(), 2).number(corner.y(), 2);
    record.close(']').close('}');
  }
  record.close(']');
}

}  // namespace

std::string PageEncoder::run_record(const RunHeader& header, const KeptWindow* window) const {
  RecordText record;
  record.open('{').key("r").text("run").key("format").integer(3).key("opal").text(header.opal);
  record.key("log").text(header.log).key("config").text(header.config).key("map").text(header.map_file);
  record.key("sensor").text(header.sensor);
  record.key("T_base_laser").open('[').pose(header.T_base_laser, kLocalDecimals).close(']');
  record.key("range_max_m").number(header.range_max_m, 3);
  record.key("unit_m").number(detail_.unit_m, 6).key("unit_rad").number(detail_.unit_rad, 6);
  record.key("unit_nat").number(detail_.unit_nat, 6).key("scan_unit_m").number(detail_.scan_unit_m, 6);
  record.key("reduced").open('[');
  for (const std::string& sentence : detail_.reduced) record.text(sentence);
  record.close(']');
  if (window) write_window(*window, record);
  return record.close('}').take();
}

std::string PageEncoder::map_record(const RunHeader& header) const {
  RecordText record;
  record.open('{').key("r").text("map").key("name").text(header.map_name);
  record.key("objects").open('[');
  for (const auto& object : header.objects) {
    record.open('[').text(object.id).text(object.type);
    if (!object.name.empty()) record.text(object.name);
    record.close(']');
  }
  record.close(']').key("features").open('[');
  for (const auto& feature : header.features) write_mapped_feature(feature, record);
  record.close(']').key("patterns").open('[');
  for (const auto& pattern : header.patterns) {
    record.open('{').key("id").text(pattern.id).key("template").text(pattern.pattern_template);
    record.key("features").open('[');
    for (const MapFeatureNumber member : pattern.features) record.text(header.feature(member).id);
    record.close(']').close('}');
  }
  record.close(']');
  if (!header.storeys.empty()) write_storeys(header, record);
  return record.close('}').take();
}

std::string PageEncoder::frame_record(const RunFrame& frame, const Words& words, const Restatement* restated) {
  if (frame.starts || restated) rows_.clear();
  const std::size_t shown = std::min(frame.hypotheses.size(), static_cast<std::size_t>(detail_.most_hypotheses));
  const std::span<const RecordedHypothesis> hypotheses(frame.hypotheses.data(), shown);
  RecordText record;
  record.open('{');
  write_moment(frame, record);
  write_scan(frame, detail_, record);
  if (restated) write_restatement(restated->state, restated->path, record);
  write_local_features(restated ? features_of(restated->state) : frame.changed, frame.gone, record);
  write_tree(frame, record);
  if (frame.search) write_search(*frame.search, record);
  rows_.write(hypotheses, as_written(frame.T_local_base), record);
  if (shown < frame.hypotheses.size()) record.key("alive").integer(static_cast<long long>(frame.hypotheses.size()));
  write_beliefs(hypotheses, static_cast<std::size_t>(detail_.most_scores), record);
  write_answer(frame, record);
  write_words(words, frame.starts || restated, record);
  return record.close('}').take();
}

void PageEncoder::write_words(const Words& words, bool first, RecordText& record) {
  if (!first && words == words_) return;
  words_ = words;
  record.key("words").open('[');
  for (const auto& [kind, text] : words) record.open('[').text(kind).text(text).close(']');
  record.close(']');
}

}  // namespace opal
