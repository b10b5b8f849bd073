#include "ipc/remote/remote_localization.hpp"

#include "ipc/loopback/loopback_http.hpp"
#include "ipc/remote/localization_messages.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>
#include <opal/common/strict_json.hpp>
#include "common/json/config_object.hpp"

#include <fmt/format.h>

namespace opal::remote {
namespace {

using nlohmann::json;

/// What ends a scan's question without an answer, and is no fault of the scan.
class NoAnswer : public Error {
 public:
  using Error::Error;
};

class StartedAnew : public NoAnswer {
 public:
  using NoAnswer::NoAnswer;
};

std::pair<std::string, int> host_and_port(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  const auto stated = colon == std::string::npos ? std::nullopt : parse_number<int>(address.substr(colon + 1));
  const int port = stated.value_or(0);
  if (port < 1 || port > 65535) throw ConfigError("'" + address + "': expected HOST:PORT, e.g. 127.0.0.1:8714");
  return {address.substr(0, colon), port};
}

std::chrono::microseconds in_microseconds(double seconds) {
  return std::chrono::microseconds(static_cast<std::int64_t>(1e6 * seconds));
}

std::string first_line(const std::string& text) { return text.substr(0, std::min<std::size_t>(text.find('\n'), 300)); }

std::string words_of(httplib::Error error) {
  if (error == httplib::Error::Connection) return "no program listens there";
  return "no answer (" + httplib::to_string(error) + ")";
}

}  // namespace

struct RemoteLocalization::Implementation {
  Implementation(std::string where, const LaserModel& laser_model, const RemoteOptions& remote_options)
      : address(std::move(where)),
        laser(laser_model),
        options(remote_options),
        client(host_and_port(address).first, host_and_port(address).second) {
    client.set_keep_alive(true);
    client.set_tcp_nodelay(true);
  }

  json expect_json(const httplib::Result& result, std::size_t most_bytes) const;
  json post(const char* path, const json& message, double timeout_s);
  void get_map();
  void begin();
  void ask(const RawScan& raw);
  void refuse_usurped(const httplib::Response& response) const;

  const std::string address;
  const LaserModel laser;
  const RemoteOptions options;
  httplib::Client client;
  std::unique_ptr<const MapView> map;
  std::string session;  ///< empty: a drive must be begun
  std::string trouble;
  bool keep_pattern = false;
  Scan scan;
  Pose2 T_odom_base;
  Answer answer;
};

json RemoteLocalization::Implementation::expect_json(const httplib::Result& result, std::size_t most_bytes) const {
  if (!result)
    throw NoAnswer(address + ": " + words_of(result.error()) + ", expected the program that localizes (opal serve)");
  if (result->status >= 500) throw NoAnswer(address + ": " + first_line(result->body));
  if (result->status == 409) refuse_usurped(*result);
  if (result->status != 200) throw Error(fmt::format("{}: {} {}", address, result->status, first_line(result->body)));
  JsonLimits limits;
  limits.bytes = most_bytes;
  return parse_json(result->body, address, limits);
}

/// The program has not been started anew: so another robot has begun.
void RemoteLocalization::Implementation::refuse_usurped(const httplib::Response& response) const {
  const std::string run = response.get_header_value("Opal-Run");
  if (!run.empty() && session.starts_with(run + "."))
    throw Error(address + ": localizes another robot by now, which has begun a drive after this one");
  throw StartedAnew(address + ": has been started anew");
}

json RemoteLocalization::Implementation::post(const char* path, const json& message, double timeout_s) {
  client.set_connection_timeout(in_microseconds(timeout_s));
  client.set_read_timeout(in_microseconds(timeout_s));
  client.set_write_timeout(in_microseconds(timeout_s));
  return expect_json(client.Post(path, message.dump(), "application/json"), kMostBytes);
}

void RemoteLocalization::Implementation::get_map() {
  client.set_read_timeout(in_microseconds(options.begin_s));
  const json message = expect_json(client.Get("/v1/map"), std::size_t{1} << 30);
  ConfigObject object(message, address);
  if (object.integer("protocol", 0) != kProtocol) object.refuse("protocol", std::to_string(kProtocol));
  const std::string sensor = object.required_text("sensor");
  map = std::make_unique<const MapView>(SemanticMap::parse(object.any("map").dump(), address), sensor);
}

void RemoteLocalization::Implementation::begin() {
  session.clear();
  answer = {};
  keep_pattern = false;
  const json message = post("/v1/begin", to_json(laser), options.begin_s);
  session = ConfigObject(message, address).required_text("session");
}

void RemoteLocalization::Implementation::ask(const RawScan& raw) try {
  if (session.empty()) begin();
  const json said = post("/v1/scans", to_json(ScanMessage{session, raw, keep_pattern}), options.timeout_s);
  answer = answer_from(said);
  keep_pattern = false;
  trouble.clear();
} catch (const StartedAnew& error) {
  trouble = error.what();
  session.clear();
} catch (const NoAnswer& error) {
  trouble = error.what();
} catch (const JsonError& error) {
  trouble = error.what();
} catch (const ConfigError& error) {
  trouble = address + ": " + error.what();
}

RemoteLocalization::RemoteLocalization(const std::string& address, const LaserModel& laser,
                                       const RemoteOptions& options)
    : implementation_(std::make_unique<Implementation>(address, laser, options)) {
  implementation_->get_map();
}

RemoteLocalization::~RemoteLocalization() = default;

void RemoteLocalization::begin() {
  implementation_->begin();
  implementation_->trouble.clear();
}

void RemoteLocalization::take(const RawScan& raw) {
  implementation_->T_odom_base = navigation::of_three_numbers(raw.T_odom_base.value());
  implementation_->scan = make_scan(raw, implementation_->laser);
  implementation_->ask(raw);
}

void RemoteLocalization::keep_pattern() { implementation_->keep_pattern = true; }

bool RemoteLocalization::answers() const { return implementation_->trouble.empty(); }
const std::string& RemoteLocalization::trouble() const { return implementation_->trouble; }
PoseEstimate RemoteLocalization::estimate() const { return implementation_->answer.estimate; }
const Scan& RemoteLocalization::newest_scan() const { return implementation_->scan; }
const Pose2& RemoteLocalization::T_odom_base() const { return implementation_->T_odom_base; }
const LaserModel& RemoteLocalization::laser() const { return implementation_->laser; }
std::vector<Geometry> RemoteLocalization::pattern() const { return implementation_->answer.pattern; }
const MapView& RemoteLocalization::map() const { return *implementation_->map; }

}  // namespace opal::remote
