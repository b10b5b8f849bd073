#include "room.hpp"

#include "closed_loop/closed_loop.hpp"
#include "ipc/loopback/loopback_http.hpp"
#include "ipc/remote/localization_messages.hpp"
#include "ipc/remote/remote_localization.hpp"
#include "navigation/node_registry.hpp"

#include <opal/common/error.hpp>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include <thread>

using namespace opal;
using namespace std::chrono_literals;
using nlohmann::json;
using remote::RemoteLocalization;

namespace {

constexpr const char* kJson = "application/json";

simulation::Simulation standing() { return simulation::Simulation(room(), world(), 3); }

/// The next scan, 0.1 s later.
RawScan next(simulation::Simulation& simulation) {
  simulation.drive({}, 0.1);
  return simulation.scan();
}

/// A connection that says what no HTTP client would.
class RawConnection {
 public:
  explicit RawConnection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, kLoopback, &address.sin_addr);
    REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  }
  ~RawConnection() { ::close(socket_); }
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;
  void say(const std::string& bytes) { static_cast<void>(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL)); }

 private:
  int socket_;
};

/// A program that is not what it seems.
class Impostor {
 public:
  explicit Impostor(const std::function<void(httplib::Response&)>& to_scans) {
    const std::string map =
        json{{"protocol", remote::kProtocol}, {"sensor", LaserModel().id}, {"map", room()->to_json_ld()}}.dump();
    httplib::Server& http = server_.http;
    http.Get("/v1/map", [map](const httplib::Request&, httplib::Response& r) { r.set_content(map, kJson); });
    http.Post("/v1/begin",
              [](const httplib::Request&, httplib::Response& r) { r.set_content(R"({"session":"x.1"})", kJson); });
    http.Post("/v1/scans", [to_scans](const httplib::Request&, httplib::Response& r) { to_scans(r); });
    server_.listen(0, "");
  }
  ~Impostor() { server_.stop(); }
  std::string address() const { return "127.0.0.1:" + std::to_string(server_.port()); }

 private:
  LoopbackServer server_;
};

json scan_message(const std::string& session, double stamp_s) {
  return {{"session", session},
          {"stamp_s", stamp_s},
          {"T_odom_base", {0, 0, 0}},
          {"ranges_m", std::vector<double>(541, 2.0)}};
}

/// Takes the program away for some scans.
class Interrupted : public RemoteLocalization {
 public:
  Interrupted(std::unique_ptr<remote::LocalizationServer>& program, const LaserModel& laser)
      : RemoteLocalization(program->address(), laser, {20, 60}), program_(program), port_(program->port()) {}
  void take(const RawScan& scan) override {
    ++scans_;
    if (scans_ == 20) program_.reset();
    if (scans_ == 25) program_ = server(port_);
    RemoteLocalization::take(scan);
  }

 private:
  std::unique_ptr<remote::LocalizationServer>& program_;
  int port_, scans_ = 0;
};

}  // namespace

TEST_CASE("without a program that localizes there is an error that names the address") {
  CHECK_THROWS_WITH(RemoteLocalization("127.0.0.1:1", world().laser),
                    Catch::Contains("127.0.0.1:1") && Catch::Contains("opal serve"));
  CHECK_THROWS_WITH(RemoteLocalization("nonsense", world().laser), Catch::Contains("HOST:PORT"));
  CHECK_THROWS_WITH(RemoteLocalization("127.0.0.1:99999", world().laser), Catch::Contains("HOST:PORT"));
}

TEST_CASE("two programs do not share a port") {
  const auto one = server();
  CHECK_THROWS_WITH(server(one->port()), Catch::Contains("another program"));
}

TEST_CASE("a program that goes away is noticed, and so is one that comes back") {
  auto program = server();
  const int port = program->port();
  auto simulation = standing();
  RemoteLocalization localization(program->address(), world().laser, {20, 60});
  localization.begin();
  localization.take(next(simulation));
  REQUIRE(localization.answers());
  program.reset();
  localization.take(next(simulation));
  CHECK_FALSE(localization.answers());
  CHECK_THAT(localization.trouble(), Catch::Contains(std::to_string(port)));
  program = server(port);
  for (int k = 0; k < 3; ++k) localization.take(next(simulation));
  CHECK(localization.answers());
  CHECK(localization.trouble().empty());
}

TEST_CASE("a robot stands still while localization is away, and gets to its goal when it is back") {
  auto program = server();
  Interrupted localization(program, world().laser);
  simulation::Simulation simulation(room(), world(), 1);
  Random random(1);
  ClosedLoopOptions options;
  options.motion.radius_m = world().robot_radius_m;
  options.most_s = 240;
  options.tick_s = 0.1;
  const auto tree =
      navigation::read_tree(navigation::standard_nodes(), OPAL_SOURCE_DIR "/configs/behaviours.jsonld", "disambiguate");
  const DriveRecord record = drive_to_goal(simulation, localization, navigation::mapped_floor(localization.map(), 0.2),
                                           *tree, simulation.floor().anywhere(random), options);
  CHECK(record.unanswered_scans >= 5);
  CHECK(record.unanswered_scans < 12);
  CHECK(record.reached);
  CHECK(record.collisions.empty());
}

TEST_CASE("what cannot be understood is answered by a sentence and changes nothing") {
  const auto program = server();
  auto simulation = standing();
  RemoteLocalization robot(program->address(), world().laser, {20, 60});
  robot.begin();
  robot.take(next(simulation));
  httplib::Client stranger(kLoopback, program->port());
  const auto post = [&](const char* path, const std::string& body, const char* type = kJson) {
    const auto result = stranger.Post(path, body, type);
    REQUIRE(result);
    return *result;
  };

  CHECK(post("/v1/scans", "no JSON").status == 400);
  CHECK(post("/v1/scans", "[1,2").status == 400);
  CHECK(post("/v1/scans", std::string(1000, '[')).status == 400);
  CHECK_THAT(post("/v1/scans", "{}").body, Catch::Contains("scan: /session: absent"));
  json twisted = scan_message("x", 1);
  twisted["ranges_m"] = "many";
  CHECK_THAT(post("/v1/scans", twisted.dump()).body, Catch::Contains("/ranges_m") && Catch::Contains("many"));
  twisted = scan_message("x", 1);
  twisted["T_odom_base"] = {0, 0};
  CHECK_THAT(post("/v1/scans", twisted.dump()).body, Catch::Contains("3 numbers"));
  twisted = scan_message("x", 1);
  twisted["keep_pattern"] = 2;
  CHECK_THAT(post("/v1/scans", twisted.dump()).body, Catch::Contains("/keep_pattern"));
  twisted = scan_message("x", 1);
  twisted["rnages"] = 1;
  CHECK_THAT(post("/v1/scans", twisted.dump()).body, Catch::Contains("unknown key"));
  CHECK(post("/v1/scans", scan_message("x", 1).dump()).status == 409);
  json laser = remote::to_json(world().laser);
  laser["beams"] = 2'000'000'000;
  CHECK_THAT(post("/v1/begin", laser.dump()).body, Catch::Contains("laser: /beams"));
  CHECK(post("/v1/scans", scan_message("x", 1).dump(), "text/plain").status == 415);
  CHECK_THAT(post("/v2/scans", "{}").body, Catch::Contains("version 1"));
  CHECK(post("/v1/elsewhere", "{}").status == 404);

  robot.take(next(simulation));
  CHECK(robot.answers());
}

TEST_CASE("a message that is huge, garbage, unfinished or from elsewhere takes nothing down") {
  const auto program = server();
  auto simulation = standing();
  RemoteLocalization robot(program->address(), world().laser, {20, 60});
  robot.begin();
  httplib::Client stranger(kLoopback, program->port());
  if (const auto huge = stranger.Post("/v1/scans", std::string(remote::kMostBytes + 1, ' '), kJson))
    CHECK(huge->status == 413);
  const auto foreign = stranger.Get("/v1/map", {{"Host", "evil.example"}});
  REQUIRE(foreign);
  CHECK(foreign->status == 403);
  RawConnection garbage(program->port()), unfinished(program->port()), silent(program->port());
  garbage.say(std::string(100'000, '\xff'));
  unfinished.say("POST /v1/scans HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 1000000\r\n\r\n{");
  for (int k = 0; k < 3; ++k) robot.take(next(simulation));
  CHECK(robot.answers());
}

TEST_CASE("a scan that is not later than the one before is refused") {
  const auto program = server();
  auto simulation = standing();
  RemoteLocalization robot(program->address(), world().laser, {20, 60});
  robot.begin();
  const RawScan scan = next(simulation);
  robot.take(scan);
  CHECK_THROWS_WITH(robot.take(scan), Catch::Contains("/stamp_s") && Catch::Contains("more than"));
  robot.take(next(simulation));
  CHECK(robot.answers());
}

TEST_CASE("a robot is told when another one has begun") {
  const auto program = server();
  auto simulation = standing();
  RemoteLocalization first(program->address(), world().laser, {20, 60}),
      second(program->address(), world().laser, {20, 60});
  first.begin();
  first.take(next(simulation));
  second.begin();
  CHECK_THROWS_WITH(first.take(next(simulation)), Catch::Contains("another robot"));
  second.take(next(simulation));
  CHECK(second.answers());
}

TEST_CASE("a program that is silent, or answers nonsense, counts as away") {
  auto simulation = standing();
  const auto trouble_with = [&](const std::function<void(httplib::Response&)>& to_scans) {
    const Impostor impostor(to_scans);
    RemoteLocalization robot(impostor.address(), world().laser, {0.2, 60});
    robot.begin();
    robot.take(next(simulation));
    CHECK_FALSE(robot.answers());
    return robot.trouble();
  };
  CHECK_THAT(trouble_with([](httplib::Response&) { std::this_thread::sleep_for(500ms); }),
             Catch::Contains("opal serve"));
  CHECK_THAT(trouble_with([](httplib::Response& r) { r.set_content("hello", "text/plain"); }),
             Catch::Contains("127.0.0.1"));
  CHECK_THAT(trouble_with([](httplib::Response& r) { r.set_content(R"({"stamp_s":1,"status":"fine"})", kJson); }),
             Catch::Contains("searching, ambiguous"));
  CHECK_THAT(trouble_with([](httplib::Response& r) { r.status = 500, r.set_content("out of memory", "text/plain"); }),
             Catch::Contains("out of memory"));
}
