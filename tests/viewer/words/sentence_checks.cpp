#include "sentence_checks.hpp"

#include "localization/alignment/registration.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <regex>

using namespace opal;
using nlohmann::ordered_json;

namespace {

/// Two texts of one number may differ by rounding.
void check_number(const std::string& said, double recorded, int decimals) {
  CAPTURE(said, recorded);
  CHECK(std::abs(std::stod(said) - recorded) <= 0.5001 * std::pow(10, -decimals) + 2e-6);
}

const ordered_json* row_of(const StreamBooks& books, int hypothesis) {
  for (const auto& row : books.estimate["hypotheses"])
    if (row["hypothesis"] == hypothesis) return &row;
  return nullptr;
}

std::smatch match(const std::string& text, const std::string& pattern) {
  static std::map<std::string, std::regex> compiled;
  auto [it, added] = compiled.try_emplace(pattern);
  if (added) it->second = std::regex(pattern);
  std::smatch found;
  CAPTURE(text);
  REQUIRE(std::regex_search(text, found, it->second));
  return found;
}

void check_pose(const std::smatch& said, std::size_t from, const Pose2& pose) {
  check_number(said[from], pose.x(), 2);
  check_number(said[from + 1], pose.y(), 2);
}

void check_answer(const std::string& text, const StreamBooks& books) {
  const ordered_json& estimate = books.estimate;
  if (const auto reason = text.find(": "); text.starts_with("not localized yet") || text.starts_with("lost: ")) {
    CHECK(text.substr(reason + 2) == estimate["why"].get<std::string>());
    return;
  }
  const auto said = match(
      text,
      R"(^(\w+)(?: \(a place is found, but not proven yet\))? since ([\d.]+) s: (.*); "none of these" has ([\d.]+)$)");
  CHECK(said[1] == estimate["status"].get<std::string>());
  check_number(said[2], books.status_since_s, 1);
  check_number(said[4], estimate["none"], 3);
  if (!estimate.contains("hypothesis")) {
    CHECK(said[3] == "no hypothesis is alive");
    return;
  }
  const std::string rest = said[3];
  const auto best = match(
      rest, R"(^at \((\S+), (\S+)\), heading (\S+) deg, with probability (\S+) \(hypothesis (\d+), (\d+) alive\)$)");
  check_pose(best, 1, pose_of(estimate["T_map_base"]));
  check_number(best[3], pose_of(estimate["T_map_base"]).heading_rad() * 180 / std::numbers::pi, 1);
  check_number(best[4], estimate["probability"], 3);
  CHECK(std::stoi(best[5]) == estimate["hypothesis"]);
  CHECK(std::stoul(best[6]) == estimate["hypotheses"].size());
}

/// Distances of the best hypothesis' associations, by object.
std::map<std::string, std::vector<double>> distances(const StreamBooks& books) {
  const Pose2 T_map_local = pose_of(books.estimate["T_map_base"]) * pose_of(books.keyframe["T_local_base"]).inverse();
  std::map<std::string, std::vector<double>> by_object;
  for (const auto& [local, mapped] : books.pairs.at(books.estimate["hypothesis"])) {
    if (mapped.empty() || books.local.count(local) == 0) continue;
    const ordered_json& feature = books.mapped.at(mapped);
    const Geometry placed = transformed(T_map_local, geometry_of(books.local.at(local)));
    by_object[books.objects[feature["object"].get<int>()][0]].push_back(
        mismatch(placed, geometry_of(feature)).position_m);
  }
  return by_object;
}

void check_rests_on(const std::string& text, const StreamBooks& books) {
  const auto by_object = distances(books);
  std::size_t pairs = 0, named = 0;
  for (const auto& [id, all] : by_object) pairs += all.size();
  const auto said = match(text, R"(^rests on (\d+) associations? with (\d+) objects?: (.*)$)");
  CHECK(std::stoul(said[1]) == pairs);
  CHECK(std::stoul(said[2]) == by_object.size());
  const std::string list = said[3];
  const std::regex object(R"((\S+) (\S+) \((\S+) m\))");
  double last = 0;
  for (std::sregex_iterator it(list.begin(), list.end(), object), end; it != end; ++it, ++named) {
    const std::smatch& each = *it;
    CHECK(books.types.at(each[2]) == "opal:" + each[1].str());
    const auto& all = by_object.at(each[2]);
    check_number(each[3], *std::ranges::min_element(all), 2);
    CHECK(std::stod(each[3]) >= last);
    last = std::stod(each[3]);
  }
  CHECK(named == std::min<std::size_t>(4, by_object.size()));
}

void check_not_on_map(const std::string& text, const StreamBooks& books) {
  std::vector<int> expected;
  for (const auto& [local, mapped] : books.pairs.at(books.estimate["hypothesis"]))
    if (mapped.empty() && books.local.count(local)) expected.push_back(local);
  const auto said = match(text, R"(^takes (\d+) local features? for not on the map: ([\d, ]+))");
  CHECK(std::stoul(said[1]) == expected.size());
  std::istringstream list(said[2]);
  for (std::size_t k = 0; k < std::min<std::size_t>(8, expected.size()); ++k) {
    int id = -1;
    char comma;
    list >> id >> comma;
    CHECK(id == expected[k]);
  }
}

void check_support(const std::string& text, const StreamBooks& books) {
  if (text.starts_with("rests")) return check_rests_on(text, books);
  const ordered_json& spawned = books.spawned.at(books.estimate["hypothesis"]);
  const auto said = match(text, R"(^(spawned|branched from hypothesis (\d+)) at (\S+) s( from (.+))?$)");
  if (said[2].matched) CHECK(std::stoi(said[2]) == spawned["parent"]);
  check_number(said[3], spawned["time"], 1);
  if (said[5].matched && spawned.contains("template")) CHECK(said[5] == spawned["template"].get<std::string>());
}

void check_findings(const std::string& text, const ordered_json& findings, std::size_t most) {
  std::string expected;
  for (std::size_t k = 0; k < std::min(most, findings.size()); ++k)
    expected += (k ? "; " : "") + findings[k]["words"].get<std::string>();
  CAPTURE(text, expected);
  CHECK(text.find(expected) != std::string::npos);
}

void check_against(const std::string& text, const StreamBooks& books) {
  if (!text.starts_with("the newest scan")) return check_findings(text, books.estimate["findings"], 2);
  const double nat = (*row_of(books, books.estimate["hypothesis"]))["scan_nat"];
  CHECK(nat < 0);
  check_number(match(text, R"(scores (\S+) nat$)")[1], nat, 2);
}

void check_alternative(const std::string& text, const StreamBooks& books) {
  if (text.find("more alternative") != std::string::npos) return;
  const auto said = match(
      text,
      R"(^hypothesis (\d+) at \((\S+), (\S+)\), heading \S+ deg has probability (\S+): (.*)gathered (\S+) nat, the best one (\S+) nat$)");
  const ordered_json *alternative = row_of(books, std::stoi(said[1])),
                     *best = row_of(books, books.estimate["hypothesis"]);
  REQUIRE(alternative);
  check_pose(said, 2, pose_of((*alternative)["T_map_base"]));
  check_number(said[4], (*alternative)["probability"], 3);
  check_number(said[6], (*alternative)["log_likelihood"], 2);
  check_number(said[7], (*best)["log_likelihood"], 2);
  const std::map<std::string, std::string> terms{{"beams on mapped surfaces", "hit"},
                                                 {"beams that end where nothing is mapped", "short"},
                                                 {"beams through mapped surfaces", "through"}};
  const std::string compared = said[5];
  const std::regex term(R"(([a-z ]+?) (\d+) %, of the best one (\d+) %; )");
  for (std::sregex_iterator it(compared.begin(), compared.end(), term), end; it != end; ++it) {
    const std::string& name = terms.at((*it)[1]);
    check_number((*it)[2], 100 * (*alternative)["scores"]["opal:Beams"][name].get<double>(), 0);
    check_number((*it)[3], 100 * (*best)["scores"]["opal:Beams"][name].get<double>(), 0);
  }
}

void check_fell(const std::string& text, const StreamBooks& books) {
  const auto said =
      match(text, R"(^hypothesis (\d+) at \((\S+), (\S+)\) fell at (\S+) s: (.*); it had (\S+) at (\S+) s)");
  const int id = std::stoi(said[1]);
  const ordered_json& end = books.pruned.at(id);
  check_pose(said, 2, pose_of(end["T_map_base"]));
  check_number(said[4], end["time"], 1);
  CHECK(said[5].str().starts_with(end["reason"].get<std::string>()));
  check_findings(said[5], end["findings"], 1);
  CHECK_FALSE(end.contains("merged_into"));
  check_number(said[6], books.highest.at(id).first, 3);
  check_number(said[7], books.highest.at(id).second, 1);
}

void check_search(const std::string& text, const StreamBooks& books) {
  if (books.searched.is_null()) {
    CHECK(text == "no search is recorded so far");
    return;
  }
  const auto said = match(text, R"(^last search, at (\S+) s: looked up (\d+) patterns?.*, (\d+) places? proposed)");
  check_number(said[1], books.searched_s, 1);
  CHECK(std::stoul(said[2]) == books.searched["patterns"].size());
  CHECK(std::stoi(said[3]) == books.searched["proposed"]);
  const ordered_json& rejected = books.searched["rejected"];
  if (rejected.empty()) return;
  const auto tail =
      match(text, R"(proposed, (\d+) rejected, the best of these at \((\S+), (\S+)\) with (\S+) nat: (.*)$)");
  CHECK(std::stoul(tail[1]) == rejected.size());
  CHECK(std::ranges::any_of(rejected, [&](const ordered_json& r) { return r["reason"] == tail[5].str(); }));
}

void check_note(const std::string& text, const StreamBooks& books) {
  if (text.starts_with("\"none")) CHECK(books.estimate["none"] > books.estimate["probability"]);
  if (text.starts_with("takes ")) check_not_on_map(text, books);
  if (text.starts_with("last search") || text.starts_with("no search")) check_search(text, books);
  if (!text.starts_with("the scan")) return;
  const auto said =
      match(text, R"(has (\d+) points? \(thinned\), the local map (\d+) features?, (\d+) of them stable$)");
  CHECK(2 * std::stoul(said[1]) == books.keyframe["scan"].size());
  CHECK(std::stoul(said[2]) == books.local.size());
  CHECK(std::stol(said[3]) == std::ranges::count_if(books.local, [](const auto& entry) {
          return entry.second["stable"].template get<bool>();
        }));
}

}  // namespace

void check_sentence(const Sentence& sentence, const StreamBooks& books) {
  CAPTURE(sentence.text, books.now_s);
  switch (sentence.kind) {
    case SentenceKind::answer: return check_answer(sentence.text, books);
    case SentenceKind::support: return check_support(sentence.text, books);
    case SentenceKind::against: return check_against(sentence.text, books);
    case SentenceKind::alternative: return check_alternative(sentence.text, books);
    case SentenceKind::fell: return check_fell(sentence.text, books);
    case SentenceKind::note: return check_note(sentence.text, books);
  }
}
