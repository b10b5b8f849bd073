#include "fleet/evidence_outbox.hpp"

#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

using namespace opal;
using Catch::Contains;

namespace {

std::vector<std::string> documents_of(const std::vector<EvidenceOutbox::Entry>& entries) {
  std::vector<std::string> documents;
  for (const EvidenceOutbox::Entry& entry : entries) documents.push_back(entry.document);
  std::sort(documents.begin(), documents.end());
  return documents;
}

}  // namespace

TEST_CASE("what waits is there for another program, with its version, until it is confirmed") {
  const TemporaryFolder folder;
  EvidenceOutbox(folder.path()).keep("here", {"hall", 3}, "{\"a\": 1}");
  const EvidenceOutbox another(folder.path());
  const auto waiting = another.waiting_for("here");
  REQUIRE(waiting.size() == 1);
  CHECK(waiting[0].version.building == "hall");
  CHECK(waiting[0].version.version == 3);
  CHECK(waiting[0].document == "{\"a\": 1}");
  EvidenceOutbox::confirm(waiting[0]);
  EvidenceOutbox::confirm(waiting[0]);  // two programs may have sent it
  CHECK(another.waiting_for("here").empty());
}

TEST_CASE("the same drive waits once, for each store and each version") {
  const TemporaryFolder folder;
  const EvidenceOutbox outbox(folder.path());
  for (int k = 0; k < 2; ++k) {
    outbox.keep("here", {"hall", 1}, "one");
    outbox.keep("here", {"hall", 1}, "two");
    outbox.keep("here", {"hall", 2}, "one");
    outbox.keep("there", {"hall", 1}, "one");
  }
  CHECK(documents_of(outbox.waiting_for("here")) == std::vector<std::string>{"one", "one", "two"});
  CHECK(documents_of(outbox.waiting_for("there")) == std::vector<std::string>{"one"});
  CHECK(outbox.waiting_for("elsewhere").empty());
}

TEST_CASE("drafts of a program that was killed are not evidence, and a file of something else is named") {
  const TemporaryFolder folder;
  const EvidenceOutbox outbox(folder.path());
  outbox.keep("here", {"hall", 1}, "one");
  const std::string inside = std::filesystem::path(outbox.waiting_for("here")[0].file).parent_path().string();
  std::ofstream(inside + "/half.json.draft-1") << "{\"docu";
  CHECK(outbox.waiting_for("here").size() == 1);
  std::ofstream(inside + "/other.json") << "{\"building\": \"hall\"}";
  CHECK_THROWS_WITH(outbox.waiting_for("here"), Contains("other.json: is no evidence that Opal keeps"));
}

TEST_CASE("a folder that cannot be written is told before anything is sent") {
  const TemporaryFolder folder;
  const EvidenceOutbox outbox(folder.write("file", "no folder"));
  CHECK_THROWS_AS(outbox.keep("here", {"hall", 1}, "one"), Error);
}
