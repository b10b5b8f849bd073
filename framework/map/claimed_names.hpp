#pragma once

#include "map/map_vocabulary.hpp"
#include "map/semantic_map_draft.hpp"

#include <algorithm>
#include <cctype>
#include <memory_resource>
#include <string>
#include <string_view>
#include <unordered_map>

namespace opal {

/// What ids stand for, so that no two things have the same. The ids are the draft's own.
class ClaimedNames {
 public:
  explicit ClaimedNames(const MapDraft& draft) : draft_(draft) {
    constexpr std::size_t kPerFeature = 3;  // itself, its representation and most of its points
    what_.reserve(draft.objects.size() + kPerFeature * draft.features.size());
  }

  void claim(const std::string& id, const char* what, const std::string& place) {
    const auto [entry, is_new] = what_.try_emplace(id, what);
    if (is_new)
      check_usable(id, what, place);
    else if (std::string_view(entry->second) != what)
      draft_.fail(place, "id '" + id + "' stands for " + article(entry->second) + " and " + article(what) +
                             ", expected one id for one thing");
  }
  void claim_alone(const std::string& id, const char* what, const std::string& place) {
    const auto known = what_.find(id);
    if (known != what_.end() && std::string_view(known->second) == what)
      draft_.fail(place, "id '" + id + "' stands for two " + what + "s, expected an id of its own");
    claim(id, what, place);
  }

 private:
  static std::string article(const std::string& noun) { return (noun == "object" ? "an " : "a ") + noun; }

  void check_usable(const std::string& id, const char* what, const std::string& place) const {
    if (id.empty()) draft_.fail(place, std::string("the id of a ") + what + " is empty, expected a name");
    const bool keyword = id.size() > 1 && id[0] == '@' && std::all_of(id.begin() + 1, id.end(), [](char c) {
                           return std::isalpha(static_cast<unsigned char>(c)) != 0;
                         });
    if (keyword || vocabulary::is_blank(id))
      draft_.fail(place, "id '" + id + "' has a meaning of its own in JSON-LD, expected another name");
  }

  const MapDraft& draft_;
  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::unordered_map<std::string_view, const char*> what_{&memory_};
};

}  // namespace opal
