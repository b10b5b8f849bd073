#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace opal::ifc_importer {
namespace {

using Kind = Treatment::Kind;

constexpr std::size_t kIdsInSentence = 20;

/// A cut that is all circles is given as circles.
void set_outline(const ElementCut& cut, ImportedElement& element) {
  for (const Loop& loop : cut.outline)
    if (const auto circle = circle_of(loop)) element.circles.push_back(*circle);
  if (element.circles.size() != cut.outline.size()) element.outline = segments_of(cut.outline);
}

bool holds(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Ids of the things that parts belong to: of all, and of those whose parts are cut.
struct Wholes {
  std::set<std::string> all, cut;
};

Wholes wholes_of(const std::vector<ElementCut>& cuts) {
  Wholes wholes;
  for (const ElementCut& cut : cuts) {
    wholes.all.insert(cut.element->whole);
    if (cut.is_cut() && cut.object != cut.element) wholes.cut.insert(cut.object->id);
  }
  return wholes;
}

ImportedElement imported_element(const ElementCut& cut, const Duplicates& duplicates, const AssembledMap& assembled,
                                 const Wholes& wholes) {
  ImportedElement element{cut.element->id, cut.element->source_class(), cut.element->name};
  set_outline(cut, element);
  const auto decide = [&element](ImportStatus status, std::string reason) {
    element.status = status;
    element.reason = std::move(reason);
  };
  const auto kept = duplicates.kept.find(element.id);
  if (!cut.is_cut() && wholes.cut.count(element.id))
    decide(ImportStatus::imported, "its parts are cut: they have its id");
  else if (!cut.is_cut() && !cut.trouble.empty())
    decide(ImportStatus::unreadable, cut.trouble);
  else if (cut.element->bodies.empty() && cut.treatment.kind != Kind::left_out && wholes.all.count(element.id) == 0)
    decide(ImportStatus::unreadable, "it has no body, and no parts that have one");
  else if (cut.element->bodies.empty() && !cut.is_cut())
    decide(ImportStatus::not_cut, "it has no body of its own");
  else if (!cut.is_cut())
    decide(ImportStatus::not_cut, cut.is_within_reach
                                      ? "the plane meets nothing of it but openings, or it is thinner than 0.1 mm"
                                      : "the plane passes above or below it");
  else if (cut.treatment.kind == Kind::left_out)
    decide(ImportStatus::left_out, cut.treatment.reason);
  else if (kept != duplicates.kept.end())
    decide(ImportStatus::merged, "at the same place as " + kept->second);
  else if (holds(assembled.hidden, element.id))
    decide(ImportStatus::imported, "hidden in others, or thinner than 2 mm: nothing of it can be seen");
  else if (holds(assembled.hidden_rounds, element.id))
    decide(ImportStatus::imported, "round, and less than half of it stands free: no feature");
  else if (cut.treatment.kind == Kind::glass)
    decide(ImportStatus::imported, "not perceivable: " + cut.treatment.reason);
  else if (cut.object != cut.element)
    decide(ImportStatus::imported, "part of " + cut.object->id);
  if (element.status == ImportStatus::imported && !cut.trouble.empty() && cut.is_cut())
    element.reason += (element.reason.empty() ? "incomplete: " : "; incomplete: ") + cut.trouble;
  return element;
}

std::string listed(const std::vector<std::string>& ids) {
  std::string list;
  for (std::size_t k = 0; k < std::min(ids.size(), kIdsInSentence); ++k) list += " " + ids[k];
  return ids.size() > kIdsInSentence ? list + " ... (--report FILE.json has all)" : list;
}

/// "16 posts of less than 35 cm around are no features"
std::string none_made_of(int count, const char* thing, const char* which, const char* made) {
  const bool is_one = count == 1;
  return fmt::format("{} {}{} {} {} {}{}", count, thing, is_one ? "" : "s", which, is_one ? "is no" : "are no", made,
                     is_one ? "" : "s");
}

/// "IfcColumn: 46 came in, 85 merged with others at the same place, 126 not at this height".
std::vector<std::string> per_class(const std::vector<ImportedElement>& elements) {
  std::map<std::string, std::map<ImportStatus, int>> counts;
  for (const ImportedElement& element : elements) ++counts[element.source_class][element.status];
  const std::vector<std::pair<ImportStatus, const char*>> words{
      {ImportStatus::imported, "came in"},
      {ImportStatus::merged, "merged with others at the same place"},
      {ImportStatus::left_out, "left out"},
      {ImportStatus::unreadable, "cannot be read"},
      {ImportStatus::not_cut, "not at this height"}};
  std::vector<std::string> sentences;
  for (const auto& [class_name, by_status] : counts) {
    std::vector<std::string> texts;
    for (const auto& [status, word] : words)
      if (const auto found = by_status.find(status); found != by_status.end())
        texts.push_back(fmt::format("{} {}", found->second, word));
    sentences.push_back(fmt::format("{}: {}", class_name, fmt::join(texts, ", ")));
  }
  return sentences;
}

/// Ids by class, status and reason, for whatever somebody might miss.
std::vector<std::string> what_is_missing(const std::vector<ImportedElement>& elements) {
  std::map<std::string, std::vector<std::string>> ids;
  for (const ImportedElement& element : elements) {
    if (element.status == ImportStatus::left_out)
      ids["left out: " + element.source_class + ", " + element.reason + ":"].push_back(element.id);
    if (element.status == ImportStatus::unreadable)
      ids["cannot be read: " + element.source_class + ", " + element.reason + ":"].push_back(element.id);
    if (element.reason.find("incomplete: ") != std::string::npos)
      ids[element.source_class + ", " + element.reason + ":"].push_back(element.id);
  }
  std::vector<std::string> sentences;
  for (const auto& [what, list] : ids) sentences.push_back(what + listed(list));
  return sentences;
}

/// "not perceivable: 3 IfcWall, glass, by its name or material: ids".
std::vector<std::string> not_perceivable(const std::vector<ImportedElement>& elements) {
  constexpr std::string_view kUnseen = "not perceivable: ";
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> ids;
  for (const ImportedElement& element : elements)
    if (element.reason.starts_with(kUnseen))
      ids[{element.source_class, element.reason.substr(kUnseen.size())}].push_back(element.id);
  std::vector<std::string> sentences;
  for (const auto& [what, list] : ids)
    sentences.push_back(std::string(kUnseen) + std::to_string(list.size()) + " " + what.first + ", " + what.second +
                        ":" + listed(list));
  return sentences;
}

std::vector<std::string> about_doors(const std::vector<ElementCut>& cuts) {
  std::vector<std::string> sentences, filling_nothing;
  for (const ElementCut& cut : cuts)
    if (cut.treatment.kind == Kind::filling && cut.is_cut() && cut.element->fills.empty() && cut.element->whole.empty())
      filling_nothing.push_back(cut.element->id);
  if (!filling_nothing.empty())
    sentences.push_back("fill no opening, so that a wall may close them:" + listed(filling_nothing));
  if (const double width_m = widest_door_m(cuts); width_m > 0)
    sentences.push_back(fmt::format(
        "widest door {:.2f} m: straight things up to that length may be open doors, walls should be detected "
        "from there on "
        "(opal:LineDetector, min_length_m)",
        width_m));
  return sentences;
}

}  // namespace

std::vector<ImportedElement> imported_elements(const std::vector<ElementCut>& cuts, const Duplicates& duplicates,
                                               const AssembledMap& assembled) {
  const Wholes wholes = wholes_of(cuts);
  std::vector<ImportedElement> elements;
  for (const ElementCut& cut : cuts) elements.push_back(imported_element(cut, duplicates, assembled, wholes));
  return elements;
}

std::string unread(const std::vector<ElementCut>& cuts) {
  const auto is_unread = [](const ElementCut& cut) { return !cut.trouble.empty(); };
  const auto first = std::find_if(cuts.begin(), cuts.end(), is_unread);
  if (first == cuts.end()) return "";
  return "; cannot be read: " + std::to_string(std::count_if(first, cuts.end(), is_unread)) + " things, the first is " +
         first->element->source_class() + " " + first->element->id + ": " + first->trouble;
}

double widest_door_m(const std::vector<ElementCut>& cuts) {
  double width_m = 0;
  for (const ElementCut& cut : cuts)
    if (cut.treatment.type == "opal:Door") width_m = std::max(width_m, cut.width_m);
  return width_m;
}

std::vector<std::string> report(const Building& building, const LevelChoice& level, const std::vector<ElementCut>& cuts,
                                const std::vector<ImportedElement>& elements, const Plan& plan,
                                const AssembledMap& assembled) {
  std::vector<std::string> sentences;
  const auto append = [&sentences](const std::vector<std::string>& more) {
    sentences.insert(sentences.end(), more.begin(), more.end());
  };
  sentences.push_back(fmt::format("{} in {}: {} {}, {} things", building.schema, building.unit_name,
                                  building.levels.size(), building.levels.size() == 1 ? "storey" : "storeys",
                                  building.elements.size()));
  sentences.push_back(level.sentence);
  append(per_class(elements));
  sentences.push_back(fmt::format("{} wall faces, {:.0f} m; {} corners; {} round columns", assembled.faces,
                                  assembled.length_m, assembled.corners, assembled.circles));
  if (assembled.specks > 0) sentences.push_back(none_made_of(assembled.specks, "face", "shorter than 2 cm", "feature"));
  if (assembled.posts > 0)
    sentences.push_back(none_made_of(assembled.posts, "post", "of less than 35 cm around", "feature"));
  if (plan.closed_voids > 0)
    sentences.push_back(none_made_of(plan.closed_voids, "hollow space", "of less than 0.25 m2", "room"));
  append(not_perceivable(elements));
  append(about_doors(cuts));
  append(what_is_missing(elements));
  if (building.north_rad)
    sentences.push_back(fmt::format("true north is at {:.1f} degrees from the x axis", degrees(*building.north_rad)));
  sentences.push_back(building.georeference ? "georeferenced in " + building.georeference->crs : "not georeferenced");
  append(building.notes);
  return sentences;
}

}  // namespace opal::ifc_importer
