#include "made_review.hpp"

#include "review/review_server.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <catch2/catch.hpp>

#include <httplib.h>

#include <filesystem>
#include <thread>

using namespace opal;
using namespace opal::made;
using Catch::Matchers::Contains;

namespace {

/// A review that is served, and a page that talks to it.
struct Served {
  TemporaryFolder folder;
  Review review{matter(drives())};
  ReviewFiles files{folder.path() + "/r.decisions.json", folder.path() + "/r.jsonld"};
  ReviewServer server{review, {"a note"}, files, 0};
  std::string token = server.url().substr(server.url().find("key=") + 4);

  std::string body(const std::vector<std::pair<std::string, Answer>>& answers) const {
    return to_json(said(review, answers)).dump();
  }
  httplib::Result post(const std::string& body, const httplib::Headers& headers,
                       const char* type = "application/json") const {
    return httplib::Client("127.0.0.1", server.port()).Post("/decisions", headers, body, type);
  }
  httplib::Result post(const std::string& body) const { return post(body, {{"X-Opal-Token", token}}); }
  httplib::Result get(const std::string& path, const httplib::Headers& headers = {}) const {
    return httplib::Client("127.0.0.1", server.port()).Get(path, headers);
  }
  bool has_written() const {
    return std::filesystem::exists(files.decisions) || std::filesystem::exists(files.overlay);
  }
};

}  // namespace

TEST_CASE("the page is shown to those who know the address, and to no one else") {
  const Served served;
  const auto page = served.get("/?key=" + served.token);
  REQUIRE(page);
  CHECK(page->status == 200);
  CHECK_THAT(page->body, Contains("opal-review") && Contains(served.token) && Contains("a note"));
  CHECK_THAT(page->get_header_value("Content-Security-Policy"), Contains("frame-ancestors 'none'"));
  for (const char* path : {"/", "/?key=", "/?key=1-1"}) CHECK(served.get(path)->status == 403);
  CHECK(served.get("/decisions")->status == 404);
}

TEST_CASE("each decision is in both files before the answer goes out") {
  const Served served;
  const auto answer = served.post(served.body({{"wall-2", Answer::accepted}, {"wall-0", Answer::refused}}));
  REQUIRE(answer);
  CHECK(answer->status == 200);
  const nlohmann::json told = nlohmann::json::parse(answer->body);
  CHECK(told["saved"] == "2 of 4 decided, 1 accepted");
  CHECK(told["answers"][number_of(served.review, "wall-2")]["answer"] == "accepted");
  const Decisions kept = decisions_from(read_json(served.files.decisions), "kept");
  CHECK(kept.all.size() == 2);
  CHECK(kept.map_digest == "m1");
  CHECK(read_json(served.files.overlay)["@graph"][0]["changes"].size() == 1);
}

TEST_CASE("two pages do not take each other's decisions away") {
  const Served served;
  int other_status = 0;  // Catch2 counts checks of one thread only
  std::thread other([&] { other_status = served.post(served.body({{"wall-0", Answer::refused}}))->status; });
  CHECK(served.post(served.body({{"wall-2", Answer::accepted}}))->status == 200);
  other.join();
  CHECK(other_status == 200);
  CHECK(decisions_from(read_json(served.files.decisions), "kept").all.size() == 2);
}

TEST_CASE("requests from another origin, for another host or without the token change nothing") {
  const Served served;
  const std::string body = served.body({{"wall-2", Answer::accepted}}), port = std::to_string(served.server.port());
  const auto status = [&](const httplib::Headers& headers) { return served.post(body, headers)->status; };
  CHECK(status({}) == 403);
  CHECK(status({{"X-Opal-Token", "1-1"}}) == 403);
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1"})
    CHECK(status({{"X-Opal-Token", served.token}, {"Origin", origin}}) == 403);
  CHECK(status({{"X-Opal-Token", served.token}, {"Host", "evil.example:" + port}}) == 403);
  CHECK(served.post(body, {{"X-Opal-Token", served.token}}, "text/plain")->status == 415);
  CHECK(served.get("/?key=" + served.token, {{"Origin", "http://evil.example"}})->status == 403);
  CHECK_FALSE(served.has_written());
  CHECK(status({{"X-Opal-Token", served.token}, {"Origin", "http://127.0.0.1:" + port}}) == 200);
  CHECK(served.has_written());
}

TEST_CASE("what is too large, no JSON or no decision is refused in words and changes nothing") {
  const Served served;
  const std::string large(ReviewServer::kLargestPost + 1, ' ');
  CHECK(served.post(large)->status == 413);
  const auto refused = [&](const std::string& body, const std::string& words) {
    const auto answer = served.post(body);
    REQUIRE(answer);
    CHECK(answer->status == 400);
    CHECK_THAT(answer->body, Contains("the page: ") && Contains(words));
  };
  refused("{", "expected");
  refused(std::string(1000, '['), "nested");
  refused("{}", "/opal_decisions: absent");
  refused(R"({"opal_decisions":1,"opal_decisions":1})", "opal_decisions");
  Decisions disputed = said(served.review, {{"wall-3", Answer::accepted}});
  refused(to_json(disputed).dump(), "visits contradict each other");
  disputed = said(served.review, {{"wall-2", Answer::accepted}});
  disputed.all[0].about.id = "<script>";
  refused(to_json(disputed).dump(), "expected one of the 4 proposals");
  CHECK_FALSE(served.has_written());
}

TEST_CASE("what cannot be written is told, and the decision is taken once it can") {
  Served served;
  std::filesystem::create_directory(served.files.decisions);
  const std::string body = served.body({{"wall-2", Answer::accepted}});
  const auto answer = served.post(body);
  REQUIRE(answer);
  CHECK(answer->status == 500);
  CHECK_THAT(answer->body, Contains("r.decisions.json"));
  std::filesystem::remove(served.files.decisions);
  CHECK(served.post(body)->status == 200);
  CHECK(decisions_from(read_json(served.files.decisions), "kept").all.size() == 1);
}

TEST_CASE("a port that is taken is an error that names it and says what to do about the review") {
  const Served served;
  Review review(matter(drives()));
  CHECK_THROWS_WITH(ReviewServer(review, {}, served.files, served.server.port()),
                    Contains("127.0.0.1:" + std::to_string(served.server.port())) && Contains("--port"));
}
