#include "viewer/encoding/page_encoder.hpp"
#include "recorded_run.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <optional>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// What framework/viewer/page/README.md says how to read records, and nothing else.
class RecordReader {
 public:
  struct Row {
    HypothesisId id;
    Pose2 T_map_base;
    double nat;
  };

  explicit RecordReader(const Event& run)
      : unit_m_(run["unit_m"]), unit_rad_(run["unit_rad"]), unit_nat_(run["unit_nat"]) {}

  void read(const Event& frame) {
    if (frame.contains("start") || frame.contains("restated")) rows_.clear();
    const Pose2 local = pose(frame["local"]);
    for (const Event& place : frame.value("leave", Event::array())) rows_.erase(rows_.begin() + place.get<int>());
    REQUIRE(frame.contains("rows") == !rows_.empty());
    for (std::size_t k = 0; k < rows_.size(); ++k) carry(rows_[k], frame["rows"], k, local_.inverse() * local);
    for (const Event& row : frame.value("enter", Event::array()))
      rows_.push_back({row[0], scaled(row[1], row[2], row[3]), row[4].get<double>() * unit_nat_});
    local_ = local;
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  static Pose2 pose(const Event& array) { return {array[0], array[1], array[2]}; }
  Pose2 scaled(long long x, long long y, long long heading) const {
    return {double(x) * unit_m_, double(y) * unit_m_, double(heading) * unit_rad_};
  }
  void carry(Row& row, const Event& steps, std::size_t k, const Pose2& D) const {
    row.T_map_base = row.T_map_base * D * scaled(steps[0][k], steps[1][k], steps[2][k]);
    row.nat += steps[3][k].get<double>() * unit_nat_;
  }

  double unit_m_, unit_rad_, unit_nat_;
  std::vector<Row> rows_;
  Pose2 local_;
};

void check_points(const Event& coded, const std::vector<Point>& points, double unit_m) {
  REQUIRE(coded.size() == 2 * points.size());
  long long x = 0, y = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    x += coded[2 * k].get<long long>();
    y += coded[2 * k + 1].get<long long>();
    REQUIRE(std::abs(double(x) * unit_m - points[k].x()) <= unit_m / 2 + 1e-9);
    REQUIRE(std::abs(double(y) * unit_m - points[k].y()) <= unit_m / 2 + 1e-9);
  }
}

}  // namespace

TEST_CASE("after thousands of frames a reader has every pose within half a step") {
  const ReadRun run = frames_of({4000, 12, 6, 2, 7});
  for (const PageDetail& detail : page_details()) {
    PageEncoder encoder(detail);
    RecordReader reader(Event::parse(encoder.run_record(*run.header)));
    for (const RunFrame& frame : run.frames) {
      reader.read(Event::parse(encoder.frame_record(frame)));
      const std::size_t shown = std::min(frame.hypotheses.size(), std::size_t(detail.most_hypotheses));
      REQUIRE(reader.rows().size() == shown);
      for (const auto& row : reader.rows()) {
        const auto truth = std::ranges::find_if(frame.hypotheses, [&](const auto& h) { return h.id == row.id; });
        REQUIRE(truth - frame.hypotheses.begin() < std::ptrdiff_t(shown));
        // Half a step in x and in y of the hypothesis's own frame.
        REQUIRE(distance_m(row.T_map_base, truth->T_map_base) <= detail.unit_m * std::sqrt(0.5) + 1e-9);
        REQUIRE(angle_between_rad(row.T_map_base, truth->T_map_base) <= detail.unit_rad / 2 + 1e-9);
        REQUIRE(std::abs(row.nat - truth->log_likelihood) <= detail.unit_nat / 2 + 1e-7);
      }
    }
  }
}

TEST_CASE("a record holds what the frame holds") {
  const ReadRun run = frames_of({60, 45, 30});
  PageEncoder encoder;
  const Event header = Event::parse(encoder.run_record(*run.header)),
              map = Event::parse(encoder.map_record(*run.header));
  CHECK(header["log"] == "hall.log.gz");
  CHECK(header["reduced"].empty());
  CHECK(map["features"].size() == run.header->features.size());
  CHECK(map["patterns"][0]["features"][2] == "column-2/rim");
  for (const RunFrame& frame : run.frames) {
    const Event record = Event::parse(encoder.frame_record(frame));
    CHECK(record["keyframe"].get<KeyframeId>() == frame.keyframe);
    CHECK(record.contains("start") == frame.starts.has_value());
    check_points(record["scan"], frame.scan, header["scan_unit_m"]);
    check_points(record["free"], frame.free_space, header["scan_unit_m"]);
    CHECK(record.value("features", Event::array()).size() == frame.changed.size());
    CHECK(record.value("gone", Event::array()) == Event(frame.gone.empty() ? Event::array() : Event(frame.gone)));
    CHECK(record.value("spawned", Event::array()).size() == frame.spawns.size());
    CHECK(record.value("grown", Event::array()).size() == frame.growths.size());
    CHECK(record.value("lost", Event::array()).size() == frame.losses.size());
    CHECK(record.value("tried", Event::array()).size() == frame.rejections.size());
    CHECK(record.value("ended", Event::array()).size() == frame.ends.size());
    CHECK(record.contains("search") == frame.search.has_value());
    CHECK(record["best"].get<HypothesisId>() == frame.best);
    CHECK(record["p"][0][1].get<double>() == Approx(frame.hypotheses[0].probability).margin(1e-4));
    CHECK(record["scores"].size() == 5);
    CHECK(record["scores"][0][2]["opal:InlierScorer"].contains("inliers"));
    CHECK(record["findings"][0][2] == 1);
    REQUIRE(record.contains("truth") == frame.truth.has_value());
    if (frame.truth) CHECK(record["truth"][0].get<double>() == Approx(frame.truth->x()).margin(6e-4));
    CHECK(record["cpu"].contains("total"));
    CHECK_FALSE(record.contains("alive"));
  }
}

TEST_CASE("a reader who begins with a record that restates knows what one knows who has read everything") {
  const ReadRun run = frames_of({300, 20, 12});
  PageEncoder encoder;
  const Event header = Event::parse(encoder.run_record(*run.header));
  RecordReader all(header);
  std::optional<RecordReader> late;
  RunState state;
  const ThinnedPath path;
  for (std::size_t k = 0; k < run.frames.size(); ++k) {
    state.apply(run.frames[k]);
    const Restatement restated{state, path};
    const Event record = Event::parse(encoder.frame_record(run.frames[k], {}, k == 200 ? &restated : nullptr));
    all.read(record);
    CHECK(record.contains("restated") == (k == 200));
    if (k == 200) {
      late.emplace(header);
      CHECK(record["restated"]["start"] == state.time_line());
      CHECK(record["restated"]["hypotheses"].size() == state.alive().size());
      CHECK(record["features"].size() == state.local_features().size());
      CHECK(record.contains("words"));
    }
    if (!late) continue;
    late->read(record);
    REQUIRE(late->rows().size() == all.rows().size());
    for (std::size_t row = 0; row < all.rows().size(); ++row) {
      CHECK(late->rows()[row].id == all.rows()[row].id);
      CHECK(distance_m(late->rows()[row].T_map_base, all.rows()[row].T_map_base) < 1e-9);
    }
  }
}

TEST_CASE("words are said when they change, and again when a time line begins") {
  RunFrame frame;
  frame.status = "lost";
  frame.starts = "a";
  PageEncoder encoder;
  const Words words{{"answer", "here"}};
  const auto said = [&](const Words& w) {
    return Event::parse(encoder.frame_record(frame, w)).value("words", Event());
  };
  CHECK(said(words) == Event::array({Event::array({"answer", "here"})}));
  frame.starts.reset();
  CHECK(said(words).is_null());
  CHECK(said({}) == Event::array());
  CHECK(said({}).is_null());
  CHECK(said(words) == Event::array({Event::array({"answer", "here"})}));
  frame.starts = "b";
  CHECK(said(words) == Event::array({Event::array({"answer", "here"})}));
}

TEST_CASE("absurd values stay JSON") {
  RunFrame frame;
  frame.status = "lost";
  frame.hypotheses = {{HypothesisId(1), {1e6, -1e6, 3}, -1e9, 0, 1, {{"s\"", "t\\\n</script>", 1e9}}}};
  frame.scan = {{1e6, 1e6}, {-1e6, -1e6}};
  frame.starts = "\xff bytes";
  PageEncoder encoder;
  CHECK_NOTHROW(Event::parse(encoder.frame_record(frame)));
  frame.hypotheses[0].T_map_base = {-1e6, 1e6, -3};
  frame.hypotheses[0].log_likelihood = 1e9;
  frame.starts.reset();
  CHECK_NOTHROW(Event::parse(encoder.frame_record(frame)));
}
