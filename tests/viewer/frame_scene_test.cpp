#include "viewer/scene/frame_scene.hpp"
#include "recorded_run.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// The state after so many frames.
RunState state_after(const ReadRun& run, std::size_t frames) {
  RunState state;
  for (std::size_t k = 0; k < frames; ++k) state.apply(run.frames[k]);
  return state;
}

}  // namespace

TEST_CASE("a picture shows what the frame and those before it say") {
  const ReadRun run = frames_of({60, 50, 40});
  for (const std::size_t frames : {1, 20, 60}) {
    const RunState state = state_after(run, frames);
    const RunFrame& frame = state.frame();
    const DrawingScene scene = scene_of(*run.header, state, {"a note"});
    REQUIRE(scene.map);
    CHECK(scene.map->features().size() == run.header->features.size());
    CHECK(scene.map->objects().size() == run.header->objects.size());
    CHECK(scene.notes == std::vector<std::string>{"a note"});
    CHECK(scene.hypotheses.size() == frame.hypotheses.size());
    CHECK(distance_m(scene.hypotheses.front().T_map_base, state.best()->T_map_base) == 0);
    CHECK(scene.scan_points.size() == frame.scan.size());
    CHECK(scene.free_space.size() == frame.free_space.size());
    CHECK(scene.local_features.size() == state.local_features().size());
    CHECK(scene.trajectory.size() == frames);
    CHECK(scene.truth.size() >= frames - 1);  // the synthetic truth ends before the last update
    CHECK(scene.contradictions.size() == frame.findings.size());
    // The hall's columns are where the local features were invented from.
    for (const auto& pair : scene.associations) CHECK((anchor_of(pair.local) - anchor_of(pair.mapped)).norm() < 60);
    for (const Point& p : scene.scan_points) {
      CHECK(p.x() > -0.5);
      CHECK(p.x() < 40.5);
      CHECK(p.y() > -0.5);
      CHECK(p.y() < 24.5);
    }
  }
}

TEST_CASE("without a best hypothesis there is a map, and no scan in a place nobody knows") {
  ReadRun run = frames_of({1, 5, 10});
  run.frames[0].best = {};
  const DrawingScene scene = scene_of(*run.header, state_after(run, 1), {});
  CHECK(scene.map);
  CHECK(scene.scan_points.empty());
  CHECK(scene.local_features.empty());
}

TEST_CASE("objects and features may share ids, also with each other") {
  ReadRun run = frames_of({1, 5, 10});
  RunHeader header = *run.header;
  for (auto& object : header.objects) object.id = "same";
  for (auto& feature : header.features) feature.id = "same";
  CHECK_NOTHROW(scene_of(header, state_after(run, 1), {}));
}
