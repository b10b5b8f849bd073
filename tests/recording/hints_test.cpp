// What somebody says of the pose: on a robot and in its recording alike.
#include "robot_messages.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace {

using namespace robot_messages;

const Topic kHints{"/initialpose", "geometry_msgs/msg/PoseWithCovarianceStamped", Wire::cdr};
const Topic kForget{"/opal/forget", "std_msgs/msg/Empty", Wire::cdr};

std::string hint_bytes(double x, double heading_rad, double variance, const std::string& frame = "map") {
  log_tests::CdrWriter cdr;
  cdr.header(5, frame).pose({x, 2, 0, 0, 0, std::sin(heading_rad / 2), std::cos(heading_rad / 2)});
  for (int i = 0; i < 36; ++i) cdr.number(i == 0 || i == 7 || i == 35 ? variance : 0.0);
  return cdr.bytes();
}

std::optional<HintMessage> decoded(const std::string& bytes) {
  return decode_hint(std::as_bytes(std::span(bytes)), Wire::cdr);
}

/// Hints before the robot is known, and while it drives; and somebody wants all to be forgotten.
std::vector<ReceivedMessage> drive_with_hints() {
  std::vector<ReceivedMessage> messages{received(kHints, 0.5, hint_bytes(1, 0, 0)),
                                        received(kStatic, 0.8, laser_link(0.3))};
  for (double s = 1; s < 2; s += 0.1) {
    messages.push_back(received(kTf, s, odometry_link(s, 0)));
    messages.push_back(received(kScan, s, scan_of(s)));
  }
  messages.insert(messages.begin() + 8, received(kHints, 1.25, hint_bytes(2, 0, 0)));
  messages.insert(messages.begin() + 13, received(kForget, 1.45, std::string("\0\1\0\0\0", 5)));
  return messages;
}

TopicChoice with_hints() {
  TopicChoice topics;
  topics.scans = {"/scan"};
  topics.hints = "/initialpose";
  return topics;
}

/// Where among the records somebody has said something: "hint 1" at 0, "forget" at 7. Mounts, with which a recording
/// begins, are left out.
std::vector<std::pair<std::string, std::size_t>> said_in(std::vector<LogRecord> records) {
  std::erase_if(records, [](const LogRecord& record) { return std::holds_alternative<MountRecord>(record); });
  std::vector<std::pair<std::string, std::size_t>> said;
  for (std::size_t k = 0; k < records.size(); ++k) {
    if (const auto* hint = std::get_if<HintRecord>(&records[k]))
      said.emplace_back("hint " + std::to_string(std::lround(hint->hint.T_map_base.x())), k);
    if (std::holds_alternative<ForgetRecord>(records[k])) said.emplace_back("forget", k);
  }
  return said;
}

}  // namespace

TEST_CASE("a pose of RViz becomes a hint with its spread") {
  const auto said = decoded(hint_bytes(1, 2.5, 0.04));
  REQUIRE(said);
  CHECK(said->frame == "map");
  CHECK(said->hint.stamp_s == 5);
  CHECK(said->hint.hint.T_map_base.x() == 1);
  CHECK(said->hint.hint.T_map_base.heading_rad() == Approx(2.5));
  CHECK(said->hint.hint.sigma_m == Approx(0.2));
  CHECK(decoded(hint_bytes(1, 2.5, 0))->hint.hint.sigma_m == Approx(0.5));
}

TEST_CASE("a hint that is no pose, or cut anywhere, is none") {
  const std::string whole = hint_bytes(1, 0, 1);
  for (std::size_t length = 0; length < whole.size(); ++length) CHECK_FALSE(decoded(whole.substr(0, length)));
  CHECK_FALSE(decoded(hint_bytes(std::numeric_limits<double>::quiet_NaN(), 0, 1)));
}

TEST_CASE("what somebody says comes between the same records on a robot and in its recording") {
  RosStream stream(with_hints());
  const auto live = said_in(streamed(stream, drive_with_hints()));
  REQUIRE(live.size() == 3);
  CHECK(live[0] == std::pair<std::string, std::size_t>("hint 1", 0));
  CHECK(live[1].first == "hint 2");
  CHECK(live[2].first == "forget");
  CHECK(said_in(Recorded(drive_with_hints(), with_hints()).records) == live);
}

TEST_CASE("hints of a recording are taken only where an option names their topic") {
  const Recorded unasked(drive_with_hints());
  CHECK(said_in(unasked.records).size() == 1);  // who forgets is told nothing
  CHECK(unasked.defects.contains("hints of the pose on /initialpose are not taken: the option hint_topic may name it"));
  TopicChoice elsewhere = with_hints();
  elsewhere.hints = "/pose";
  CHECK(Recorded(drive_with_hints(), elsewhere)
            .defects.contains("no hints of the pose on /pose, which the option hint_topic names"));
  elsewhere.hints = "initialpose";  // people leave the slash out
  CHECK(said_in(Recorded(drive_with_hints(), elsewhere).records).size() == 3);
}

TEST_CASE("a robot with a name before its topics forgets in the replay, too") {
  std::vector<ReceivedMessage> messages = drive_with_hints();
  for (ReceivedMessage& message : messages)
    if (message.topic.name == kForget.name) message.topic.name = "/robot_7/opal/forget";
  CHECK(said_in(Recorded(messages).records).front().first == "forget");
}

TEST_CASE("a hint in another frame than the map's is left out, and named") {
  std::vector<ReceivedMessage> messages = drive_with_hints();
  messages.push_back(received(kHints, 3, hint_bytes(3, 0, 0, "/map")));
  messages.push_back(received(kHints, 3, hint_bytes(4, 0, 0, "odom")));
  messages.push_back(received(kHints, 3, "cut"));
  RosStream stream(with_hints());
  const auto said = said_in(streamed(stream, messages));
  REQUIRE(said.size() == 4);
  CHECK(said.back().first == "hint 3");
  CHECK(stream.defects().at("hint in frame 'odom', expected 'map'") == 1);
  CHECK(stream.defects().at("hint that is damaged, or no pose") == 1);
}
