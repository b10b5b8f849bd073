#include "map/check/map_check_mistakes.hpp"

#include "common/phrases.hpp"
#include "common/spelling.hpp"
#include "map/check/map_check_geometry.hpp"
#include "map/map_vocabulary.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>

namespace opal {
namespace {

constexpr std::size_t kMostNamed = 3;
constexpr double kLongestFace_m = 1000;

/// A word of the vocabulary for things and features that one of Opal's namespace is nearly; empty: it is one, or is
/// far from all of them.
std::string word_meant_by(const std::string& type) {
  const std::string iri = vocabulary::full_iri(type);
  if (!vocabulary::is_own(iri) || vocabulary::is_own_term(iri)) return "";
  const std::string word = iri.substr(vocabulary::kNamespace.size());
  std::string nearest;
  std::size_t least = word.size();
  for (const auto& [term, definition] : vocabulary::context_document().at("@context").items()) {
    const std::string known = vocabulary::full_iri(term);
    const bool is_type = std::isupper(static_cast<unsigned char>(term.front())) != 0;
    if (!is_type || !vocabulary::is_own(known) || !vocabulary::is_object_type(known)) continue;
    if (!is_misspelt(word, term) || letters_between(word, term) >= least) continue;
    least = letters_between(word, term);
    nearest = "opal:" + term;
  }
  return nearest;
}

void find_misspelt_types(const SemanticMap& map, std::vector<std::string>& mistakes) {
  std::map<std::string, std::vector<std::string>> ids_by_type;
  for (const MapObject& object : map.objects()) ids_by_type[object.type].push_back(in_quotes(object.id));
  for (const auto& [type, ids] : ids_by_type)
    if (const std::string meant = word_meant_by(type); !meant.empty())
      mistakes.push_back(fmt::format("type {} is no word of Opal's vocabulary, is {} meant? At {}: {}", type, meant,
                                     count_of(ids.size(), "object"), listed(ids, "", kMostNamed)));
}

}  // namespace

std::vector<std::string> mistakes_of_hand(const SemanticMap& map) {
  std::vector<std::string> mistakes, turned, long_ones, backward;
  for (const MapFeature& feature : map.features()) {
    const auto* corner = std::get_if<OrientedPoint>(&feature.geometry);
    const auto* face = std::get_if<Segment>(&feature.geometry);
    if (corner && std::abs(corner->heading_rad) > 2 * std::numbers::pi) turned.push_back(in_quotes(feature.id));
    if (face && face->length_m() > kLongestFace_m) long_ones.push_back(in_quotes(feature.id));
  }
  for (const MapFeatureNumber number : backward_faces(map)) backward.push_back(in_quotes(map.feature(number).id));
  const auto add = [&](const std::vector<std::string>& ids, const char* thing, const char* what) {
    if (!ids.empty()) mistakes.push_back(count_of(ids.size(), thing) + what + ": " + listed(ids, "", kMostNamed));
  };
  add(turned, "corner", " with a heading_rad of more than a turn, are these degrees?");
  add(long_ones, "segment", " longer than 1 km, are these millimetres?");
  add(backward, "face", " whose neighbours all run the other way, are begin and end exchanged?");
  find_misspelt_types(map, mistakes);
  return mistakes;
}

}  // namespace opal
