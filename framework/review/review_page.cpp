#include "review/review_page.hpp"

#include "report/page_template.hpp"
#include "review/page_assets.hpp"
#include "review/proposal_picture.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

namespace opal {
namespace {

using nlohmann::ordered_json;

ordered_json notes_of(const MapObject* object) {
  ordered_json json = ordered_json::object();
  if (!object) return json;
  if (!object->notes.name.empty()) json["name"] = object->notes.name;
  if (!object->notes.storey.empty()) json["storey"] = object->notes.storey;
  return json;
}

ordered_json json_of(const Review& review, std::size_t number, const ProposalPictures& pictures) {
  const ReviewMatter& matter = review.matter();
  const Proposal& proposal = matter.learned.proposals[number];
  ordered_json sights = ordered_json::array();
  for (const VisitSight& sight : proposal.sights)
    sights.push_back({{"drive", sight.drive}, {"agrees", sight.agrees}, {"words", sentence_of(proposal, sight)}});
  return {{"about", to_json(review.subjects()[number])},
          {"type", proposal.type},
          {"notes", notes_of(object_of(*matter.map, proposal))},
          {"probability", proposal.probability},
          {"proposed", proposal.probability >= matter.least_probability},
          {"objection", objection_to(proposal)},
          {"sentence", sentence_of(proposal)},
          {"sights", std::move(sights)},
          {"picture", pictures.of(proposal)}};
}

ordered_json data_of(const Review& review, const std::vector<std::string>& notes,
                     const std::optional<PageServer>& server) {
  const ReviewMatter& matter = review.matter();
  const ProposalPictures pictures(*matter.map);
  ordered_json proposals = ordered_json::array();
  for (std::size_t k = 0; k < matter.learned.proposals.size(); ++k) proposals.push_back(json_of(review, k, pictures));
  ordered_json document = to_json(Decisions{matter.map->name(), matter.map_digest, matter.evidence_digest});
  ordered_json json{{"document", std::move(document)}, {"least", matter.least_probability},
                    {"map", pictures.whole_map()},     {"proposals", std::move(proposals)},
                    {"answers", answers_of(review)},   {"notes", notes}};
  if (server)
    json["server"] = {
        {"token", server->token}, {"decisions", server->files.decisions}, {"overlay", server->files.overlay}};
  return json;
}

}  // namespace

ordered_json answers_of(const Review& review) {
  ordered_json answers = ordered_json::array();
  for (std::size_t k = 0; k < review.subjects().size(); ++k) {
    const Decision* decision = review.decision_on(k);
    if (!decision) {
      answers.push_back(nullptr);
      continue;
    }
    answers.push_back(
        {{"answer", name_of(decision->answer)}, {"by", decision->by}, {"at", decision->at}, {"note", decision->note}});
  }
  return answers;
}

std::string review_page(const Review& review, const std::vector<std::string>& notes,
                        const std::optional<PageServer>& server) {
  const std::string data = "<script type=\"application/json\" id=\"opal-review\">" +
                           json_in_html(data_of(review, notes, server)) + "</script>\n";
  constexpr std::size_t kMost = 64'000'000;
  if (data.size() > kMost)
    throw Error(fmt::format("{}: the page would have {} bytes, expected {} at most", review.matter().map->name(),
                            data.size(), kMost));
  return filled_page({kReviewIndex, kReviewStyle, kReviewScript}, data);
}

}  // namespace opal
