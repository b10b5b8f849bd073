#include "review/review_server.hpp"

#include "common/write_error.hpp"
#include "ipc/loopback/loopback_http.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <mutex>

namespace opal {
namespace {

using httplib::Request;
using httplib::Response;

}  // namespace

struct ReviewServer::Implementation {
  Implementation(Review& matter, std::vector<std::string> sentences, ReviewFiles where)
      : review(matter), notes(std::move(sentences)), files(std::move(where)) {}

  void configure();
  void show(const Request& request, Response& response);
  void take(const Request& request, Response& response);
  void take_known(const std::string& body, Response& response);

  std::mutex mutex;  ///< of the review and its files
  Review& review;
  const std::vector<std::string> notes;
  const ReviewFiles files;
  const std::string token = run_token();
  LoopbackServer server;
};

void ReviewServer::Implementation::configure() {
  constexpr int kThreads = 4;
  server.guard_pages(kThreads, kLargestPost);
  server.http.Get("/", [this](const Request& request, Response& response) { show(request, response); });
  server.http.Post("/decisions", [this](const Request& request, Response& response) { take(request, response); });
}

void ReviewServer::Implementation::show(const Request& request, Response& response) {
  if (request.get_param_value("key") != token)
    return answer(response, 403, "Open the address that the program printed when it was started.");
  const std::lock_guard lock(mutex);
  response.set_content(review_page(review, notes, PageServer{token, files}), "text/html; charset=utf-8");
}

void ReviewServer::Implementation::take(const Request& request, Response& response) {
  if (request.get_header_value("X-Opal-Token") != token)
    return answer(response, 403, "This page is of an earlier run: open the address that the program printed.");
  if (!request.get_header_value("Content-Type").starts_with("application/json"))
    return answer(response, 415, "Expected decisions as application/json.");
  try {
    take_known(request.body, response);
  } catch (const WriteError& error) {
    answer(response, 500, error.what());
  } catch (const Error& error) {
    answer(response, 400, error.what());
  }
}

void ReviewServer::Implementation::take_known(const std::string& body, Response& response) {
  const std::string name = "the page";
  const Decisions more = decisions_from(parse_json(body, name), name);
  const std::lock_guard lock(mutex);
  review.take(more, name);
  save(review, files);
  const nlohmann::ordered_json told{{"saved", review.count()}, {"answers", answers_of(review)}};
  response.set_content(told.dump(), "application/json");
}

ReviewServer::ReviewServer(Review& review, std::vector<std::string> notes, ReviewFiles files, int port)
    : implementation_(std::make_unique<Implementation>(review, std::move(notes), std::move(files))) {
  implementation_->configure();
  implementation_->server.listen(port, "choose another port with --port");
}

ReviewServer::~ReviewServer() { implementation_->server.stop(); }

int ReviewServer::port() const { return implementation_->server.port(); }
std::string ReviewServer::url() const {
  return fmt::format("http://{}:{}/?key={}", kLoopback, port(), implementation_->token);
}

}  // namespace opal
