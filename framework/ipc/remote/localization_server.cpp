#include "ipc/remote/localization_server.hpp"

#include "ipc/loopback/loopback_http.hpp"
#include "ipc/remote/localization_drives.hpp"
#include "ipc/remote/localization_messages.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

namespace opal::remote {
namespace {

using namespace std::chrono_literals;
using httplib::Request;
using httplib::Response;
using nlohmann::json;

constexpr const char* kJson = "application/json";
constexpr auto kPatience = 2s;  ///< with a peer that does not go on

json parsed(const Request& request) {
  JsonLimits limits;
  limits.bytes = kMostBytes;
  limits.depth = 8;
  return parse_json(request.body, request.path, limits);
}

/// Answers what is not of this protocol. A page of some web site can send plain text here without asking; JSON it
/// cannot.
bool refuse_foreign(const Request& request, Response& response) {
  if (!request.path.starts_with("/v1/")) {
    answer(response, 404,
           request.path.substr(0, 80) + ": unknown, this program speaks version 1: /v1/map, /v1/begin, /v1/scans");
    return true;
  }
  const std::string type = request.get_header_value("Content-Type");
  if (request.method != "POST" || type == kJson) return false;
  answer(response, 415, "Content-Type: '" + type.substr(0, 80) + "', expected " + kJson);
  return true;
}

}  // namespace

struct LocalizationServer::Implementation {
  Implementation(const std::shared_ptr<const SemanticMap>& map, std::string sensor, Maker make)
      : map_message(json{{"protocol", kProtocol}, {"sensor", std::move(sensor)}, {"map", map->to_json_ld()}}.dump()),
        drives(std::move(make)) {}

  void configure();
  void answer_scan(const Request& request, Response& response);
  void answer_trouble(Response& response, const std::exception_ptr& trouble) const;

  const std::string map_message;
  LocalizationDrives drives;
  LoopbackServer server;
};

void LocalizationServer::Implementation::configure() {
  constexpr int kThreads = 16;  // a peer that is silent holds one for as long as kPatience
  httplib::Server& http = server.http;
  server.guard(kThreads, kMostBytes, refuse_foreign);
  http.set_read_timeout(kPatience);
  http.set_write_timeout(kPatience);
  http.set_keep_alive_timeout(5);
  http.set_keep_alive_max_count(1'000'000);
  http.set_tcp_nodelay(true);
  http.set_exception_handler([this](const Request&, Response& response, const std::exception_ptr& trouble) {
    answer_trouble(response, trouble);
  });
  http.Get("/v1/map", [this](const Request&, Response& response) { response.set_content(map_message, kJson); });
  http.Post("/v1/begin", [this](const Request& request, Response& response) {
    response.set_content(json{{"session", drives.begin(laser_from(parsed(request)))}}.dump(), kJson);
  });
  http.Post("/v1/scans", [this](const Request& request, Response& response) { answer_scan(request, response); });
}

void LocalizationServer::Implementation::answer_scan(const Request& request, Response& response) {
  const auto said = drives.take(scan_from(parsed(request)));
  if (said) return response.set_content(to_json(*said).dump(), kJson);
  response.set_header("Opal-Run", drives.run());
  answer(response, 409, "scan: /session: it is not the drive that was begun last, expected a begin first");
}

void LocalizationServer::Implementation::answer_trouble(Response& response, const std::exception_ptr& trouble) const {
  try {
    std::rethrow_exception(trouble);
  } catch (const Error& error) {
    answer(response, 400, error.what());
  } catch (const std::exception& error) {
    answer(response, 500, error.what());
  }
}

LocalizationServer::LocalizationServer(const std::shared_ptr<const SemanticMap>& map, std::string sensor, Maker make,
                                       int port)
    : implementation_(std::make_unique<Implementation>(map, std::move(sensor), std::move(make))) {
  implementation_->configure();
  implementation_->server.listen(port, "choose another port with --port");
}

LocalizationServer::~LocalizationServer() { implementation_->server.stop(); }

int LocalizationServer::port() const { return implementation_->server.port(); }
std::string LocalizationServer::address() const { return fmt::format("{}:{}", kLoopback, port()); }

}  // namespace opal::remote
