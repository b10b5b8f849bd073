#include "made_review.hpp"

#include "review/proposal_picture.hpp"
#include "review/review_page.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::made;
using Catch::Matchers::Contains;

namespace {

const Proposal& proposal(const ReviewMatter& matter, const std::string& id) {
  for (const Proposal& each : matter.learned.proposals)
    if (each.id == id) return each;
  FAIL("no proposal " + id);
  throw std::runtime_error("unreachable");
}

nlohmann::json data_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"opal-review\">";
  const std::size_t from = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

}  // namespace

TEST_CASE("a picture of a moved wall has its neighbours reach up to it, as the overlay does") {
  const ReviewMatter all = matter(drives());
  const auto picture = ProposalPictures(*all.map).of(proposal(all, "wall-0"));
  CHECK(picture["mapped"]["faces"].dump() == "[0.0,0.0,8.0,0.0]");
  CHECK(picture["proposed"]["faces"].size() == 3 * 4);
  CHECK(picture["proposed"]["faces"][1].get<double>() == Approx(0.4).margin(0.01));
  CHECK(picture["sights"].size() == 2);
  CHECK(picture["sights"][0]["faces"].dump() == "[0.0,0.4,8.0,0.4]");
}

TEST_CASE("a picture of what visits contradict each other about has what each of them saw") {
  const ReviewMatter all = matter(drives());
  const auto picture = ProposalPictures(*all.map).of(proposal(all, "wall-3"));
  CHECK(picture["sights"][0]["faces"].dump() == "[0.6,6.0,0.6,0.0]");
  CHECK(picture["sights"][1]["faces"].dump() == "[-0.5,6.0,-0.5,0.0]");
}

TEST_CASE("the page has each proposal with what was said of it, and nothing in it becomes markup") {
  std::vector<DriveEvidence> evidence = drives();
  evidence[0].drive = "</script><img src=x onerror=alert(1)>";
  Review review(matter(evidence));
  Decisions decisions = said(review, {{"wall-2", Answer::refused}});
  decisions.all[0].note = "<!-- opal:script --><script>alert(2)</script>";
  review.take(decisions, "page");
  const std::string page = review_page(review, {"<b>note</b>"}, std::nullopt);
  CHECK(page.find("<img") == std::string::npos);
  CHECK(page.find("<script>") == std::string::npos);
  CHECK(page.find("<b>") == std::string::npos);
  CHECK_THAT(page, Contains("Content-Security-Policy") && Contains("default-src 'none'"));
  const nlohmann::json data = data_of(page);
  const std::size_t gone = number_of(review, "wall-2");
  CHECK(data["answers"][gone]["note"] == decisions.all[0].note);
  CHECK(data["answers"][gone]["answer"] == "refused");
  CHECK(data["answers"][number_of(review, "wall-0")].is_null());
  CHECK(data["proposals"][number_of(review, "wall-3")]["objection"] == "visits place it differently");
  CHECK(data["notes"][0] == "<b>note</b>");
  CHECK_FALSE(data.contains("server"));
}
