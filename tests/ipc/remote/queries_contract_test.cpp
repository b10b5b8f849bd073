#include "room.hpp"

#include "closed_loop/closed_loop.hpp"
#include "ipc/remote/remote_localization.hpp"
#include "navigation/node_registry.hpp"

#include <catch2/catch.hpp>

#include <functional>

using namespace opal;
using navigation::Localization;

namespace {

/// Localization in this process, and as a program beside it.
struct Both {
  std::unique_ptr<Localizer> localizer = localizer_of(world().laser);
  navigation::LocalizerQueries here{*localizer, world().laser};
  std::unique_ptr<remote::LocalizationServer> program = server();
  remote::RemoteLocalization there{program->address(), world().laser, {60, 60}};
};

bool equal(const Pose2& a, const Pose2& b) {
  return a.x() == b.x() && a.y() == b.y() && a.heading_rad() == b.heading_rad() && a.rotate({1, 0}) == b.rotate({1, 0});
}

void check_equal(const PoseEstimate& a, const PoseEstimate& b) {
  CHECK(a.stamp_s == b.stamp_s);
  CHECK(a.status == b.status);
  CHECK(a.has_pose == b.has_pose);
  CHECK(equal(a.T_map_base, b.T_map_base));
  CHECK(a.probability == b.probability);
  CHECK(a.none == b.none);
  CHECK(a.hypotheses == b.hypotheses);
  CHECK(a.best == b.best);
  REQUIRE(a.alternatives.size() == b.alternatives.size());
  for (std::size_t k = 0; k < a.alternatives.size(); ++k) {
    CHECK(a.alternatives[k].hypothesis == b.alternatives[k].hypothesis);
    CHECK(equal(a.alternatives[k].T_map_base, b.alternatives[k].T_map_base));
    CHECK(a.alternatives[k].probability == b.alternatives[k].probability);
  }
}

/// What every localization promises to behaviours (localization_queries.hpp).
void check_contract(Localization& localization) {
  simulation::Simulation simulation(room(), world(), 3);
  localization.begin();
  CHECK(localization.answers());
  CHECK_FALSE(localization.estimate().has_pose);
  CHECK(localization.laser().beams == world().laser.beams);
  CHECK(localization.map().map().features().size() == room()->features().size());
  for (int k = 0; k < 30; ++k) {
    const RawScan raw = simulation.scan();
    localization.take(raw);
    REQUIRE(localization.answers());
    CHECK(localization.estimate().stamp_s == raw.stamp_s);
    CHECK(localization.newest_scan().stamp_s == raw.stamp_s);
    CHECK(localization.newest_scan().points.size() == make_scan(raw, world().laser).points.size());
    CHECK(distance_m(localization.T_odom_base(), *raw.T_odom_base) < 1e-12);
    simulation.drive({{0.2, 0}, 0.5}, 0.2);
  }
  CHECK(localization.estimate().has_pose);
  CHECK(distance_m(localization.estimate().T_map_base, simulation.T_map_base()) < 0.5);
  localization.begin();
  CHECK_FALSE(localization.estimate().has_pose);
}

DriveRecord driven(Localization& localization, std::uint64_t seed, const char* behaviour) {
  simulation::Simulation simulation(room(), world(), seed);
  // In the room: what is behind its door is not mapped. Clutter may stand there.
  const Point goal = simulation.floor().nearest({1, 4}).value_or(Point(1, 4));
  ClosedLoopOptions options;
  options.motion.radius_m = world().robot_radius_m;
  options.most_s = 240;
  const auto tree =
      navigation::read_tree(navigation::standard_nodes(), OPAL_SOURCE_DIR "/configs/behaviours.jsonld", behaviour);
  return drive_to_goal(simulation, localization, navigation::mapped_floor(localization.map(), 0.2), *tree, goal,
                       options);
}

}  // namespace

TEST_CASE("localization keeps its promises, wherever it runs") {
  Both both;
  SECTION("in this process") { check_contract(both.here); }
  SECTION("as another program") { check_contract(both.there); }
}

TEST_CASE("another program answers the same to the last digit") {
  Both both;
  simulation::Simulation simulation(room(), world(), 5);
  both.here.begin();
  both.there.begin();
  for (int k = 0; k < 60; ++k) {
    const RawScan raw = simulation.scan();
    both.here.take(raw);
    both.there.take(raw);
    check_equal(both.here.estimate(), both.there.estimate());
    CHECK(both.here.pattern().size() == both.there.pattern().size());
    CHECK(equal(both.here.T_odom_base(), both.there.T_odom_base()));
    simulation.drive({{0.4, 0}, 0.8}, 0.2);
  }
}

TEST_CASE("a local map is reduced to the pattern on request, wherever localization runs") {
  Both both;
  simulation::Simulation simulation(room(), world(), 3);
  for (Localization* localization : {static_cast<Localization*>(&both.here), static_cast<Localization*>(&both.there)})
    localization->begin();
  const auto take = [&](const Velocity& velocity) {
    const RawScan raw = simulation.scan();
    both.here.take(raw);
    both.there.take(raw);
    simulation.drive(velocity, 0.2);
  };
  for (int k = 0; k < 30; ++k) take({{0.2, 0}, 0.8});
  REQUIRE(both.here.estimate().has_pose);
  const std::size_t before = both.localizer->local_map().features().size(), rested_on = both.here.pattern().size();
  both.here.keep_pattern();
  both.there.keep_pattern();
  CHECK(both.localizer->local_map().features().size() == before);  // not before the next scan
  take({});
  CHECK(both.localizer->local_map().features().size() < before);
  CHECK(both.here.pattern().size() < rested_on);
  CHECK(both.here.estimate().has_pose);
  for (int k = 0; k < 30; ++k) {
    check_equal(both.here.estimate(), both.there.estimate());
    CHECK(both.here.pattern().size() == both.there.pattern().size());
    take({{0.2, 0}, 0.8});
  }
  CHECK(distance_m(both.here.estimate().T_map_base, simulation.T_map_base()) < 0.5);
}

TEST_CASE("a robot drives the same way whether localization is in its process or another program") {
  Both both;
  const std::uint64_t seed = GENERATE(1u, 2u);
  const char* const behaviour = GENERATE("disambiguate", "inspect");
  const DriveRecord here = driven(both.here, seed, behaviour), there = driven(both.there, seed, behaviour);
  CHECK(here.reached);
  CHECK(here.reached == there.reached);
  CHECK(here.time_s == there.time_s);
  CHECK(here.driven_m == there.driven_m);
  REQUIRE(here.moments.size() == there.moments.size());
  for (std::size_t k = 0; k < here.moments.size(); ++k) CHECK(equal(here.moments[k].truth, there.moments[k].truth));
}
