#include "dxf_clips.hpp"

namespace opal::dxf_importer {
namespace {

// Group codes of an object.
constexpr int kHandle = 5, kSubclass = 100, kOwner = 330;
// Of a SPATIAL_FILTER.
constexpr int kClipIsOn = 71;
// The dictionary of filters and the one of all extensions.
constexpr int kDictionaries = 2;

}  // namespace

void DxfClips::take(const DxfPair& pair) {
  if (pair.code == 0) {
    object_ = {pair.value, "", "", true};
    return;
  }
  const bool is_filter = object_.type == "SPATIAL_FILTER", is_dictionary = object_.type == "DICTIONARY";
  if (!is_filter && !is_dictionary) return;
  if (pair.code == kHandle && object_.handle.empty()) object_.handle = pair.value;
  if (pair.code == kSubclass) object_.is_before_subclass = false;
  if (pair.code == kOwner && object_.is_before_subclass) object_.owner = pair.value;
  if (is_dictionary && !object_.owner.empty()) owner_of_[object_.handle] = object_.owner;
  if (is_filter && pair.code == kClipIsOn && pair.value == "1") filters_.push_back(object_.owner);
}

std::vector<std::string> DxfClips::owners() const {
  std::vector<std::string> owners;
  for (std::string owner : filters_) {
    int steps = 0;
    for (auto next = owner_of_.find(owner); next != owner_of_.end() && steps < kDictionaries; ++steps) {
      owner = next->second;
      next = owner_of_.find(owner);
    }
    if (steps == kDictionaries) owners.push_back(owner);
  }
  return owners;
}

}  // namespace opal::dxf_importer
