#include "review/decisions.hpp"

#include "common/json/config_object.hpp"
#include "common/phrases.hpp"

#include <array>

namespace opal {
namespace {

using nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr std::array kChanges{Change::moved, Change::gone, Change::added};
constexpr std::array kAnswers{Answer::undecided, Answer::accepted, Answer::refused};
constexpr std::size_t kLongestName = 200, kLongestNote = 2000;

/// The value whose name stands there.
template <class Choices>
auto choice_of(ConfigObject& object, const std::string& key, const Choices& choices) {
  const std::string word = object.required_text(key);
  for (const auto choice : choices)
    if (word == name_of(choice)) return choice;
  object.refuse(key, "one of: " + listed_by(choices, [](const auto choice) { return name_of(choice); }));
}

std::string text_of(ConfigObject& object, const std::string& key, std::size_t longest) {
  const std::string text = object.text(key, "");
  if (text.size() > longest) object.refuse(key, "a text of " + std::to_string(longest) + " bytes at most");
  return text;
}

bool are_numbers(const nlohmann::json& value) {
  return value.is_array() && std::ranges::all_of(value, [](const nlohmann::json& each) { return each.is_number(); });
}

std::vector<double> numbers_of(ConfigObject& object, const std::string& key, std::size_t count) {
  const nlohmann::json& value = object.any(key);
  if (!are_numbers(value) || value.size() != count) object.refuse(key, std::to_string(count) + " numbers in an array");
  return value.get<std::vector<double>>();
}

std::vector<std::vector<double>> mapped_of(ConfigObject& object) {
  const nlohmann::json& value = object.any("mapped");
  if (!value.is_array() || !std::ranges::all_of(value, are_numbers))
    object.refuse("mapped", "an array of arrays of numbers");
  return value.get<std::vector<std::vector<double>>>();
}

Subject subject_from(ConfigObject object) {
  Subject subject{object.required_text("id"), choice_of(object, "change", kChanges)};
  subject.is_disputed = object.boolean("disputed", false);
  if (subject.change == Change::added) {
    const std::vector<double> face = numbers_of(object, "face", 4);
    subject.face = {{face[0], face[1]}, {face[2], face[3]}};
  } else {
    subject.mapped = mapped_of(object);
  }
  if (subject.change == Change::moved) {
    const std::vector<double> moved = numbers_of(object, "moved", 2);
    subject.moved = {moved[0], moved[1]};
  }
  object.expect_no_more();
  return subject;
}

Decision decision_from(ConfigObject& object) {
  std::optional<ConfigObject> about = object.object("about");
  if (!about) object.refuse("about", "what was decided about");
  Decision decision{subject_from(*about), choice_of(object, "answer", kAnswers)};
  if (decision.answer == Answer::accepted && decision.about.is_disputed)
    object.refuse("answer", "refused or undecided: visits contradict each other");
  decision.by = text_of(object, "by", kLongestName);
  decision.at = text_of(object, "at", kLongestName);
  decision.note = text_of(object, "note", kLongestNote);
  object.expect_no_more();
  return decision;
}

ordered_json to_json(const Decision& decision) {
  ordered_json json{{"about", to_json(decision.about)}, {"answer", name_of(decision.answer)}};
  if (!decision.by.empty()) json["by"] = decision.by;
  if (!decision.at.empty()) json["at"] = decision.at;
  if (!decision.note.empty()) json["note"] = decision.note;
  return json;
}

}  // namespace

ordered_json to_json(const Subject& subject) {
  ordered_json json{{"id", subject.id}, {"change", name_of(subject.change)}};
  const Segment& face = subject.face;
  if (subject.change == Change::moved) json["moved"] = {subject.moved.x(), subject.moved.y()};
  if (subject.change == Change::added)
    json["face"] = {face.begin.x(), face.begin.y(), face.end.x(), face.end.y()};
  else
    json["mapped"] = subject.mapped;
  if (subject.is_disputed) json["disputed"] = true;
  return json;
}

ordered_json to_json(const Decisions& decisions) {
  ordered_json all = ordered_json::array();
  for (const Decision& decision : decisions.all) all.push_back(to_json(decision));
  return {{"opal_decisions", kFormat},
          {"map", decisions.map},
          {"map_digest", decisions.map_digest},
          {"evidence_digest", decisions.evidence_digest},
          {"decisions", std::move(all)}};
}

Decisions decisions_from(const nlohmann::json& document, const std::string& file) {
  ConfigObject object(document, file);
  if (object.any("opal_decisions") != kFormat)
    object.refuse("opal_decisions", "the format of decisions, " + std::to_string(kFormat));
  Decisions decisions{object.required_text("map"), object.required_text("map_digest"),
                      object.required_text("evidence_digest")};
  std::optional<std::vector<ConfigObject>> all = object.list("decisions");
  if (!all) object.refuse("decisions", "a list of decisions");
  for (ConfigObject& each : *all) decisions.all.push_back(decision_from(each));
  object.expect_no_more();
  return decisions;
}

}  // namespace opal
