#include "duplicates.hpp"

#include "point_nodes.hpp"

#include <algorithm>

namespace opal::ifc_importer {
namespace {

constexpr double kSamePlace_m = 0.001;

/// Loops whose corners are the same points, whatever corner comes first.
bool is_same_loop(const Loop& a, const Loop& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < b.size(); ++shift) {
    bool same = true;
    for (std::size_t k = 0; k < a.size() && same; ++k) same = (a[k] - b[(k + shift) % b.size()]).norm() < kSamePlace_m;
    if (same) return true;
  }
  return false;
}

bool is_same_outline(const ElementCut& a, const ElementCut& b) {
  if (a.outline.size() != b.outline.size() || a.treatment.type != b.treatment.type) return false;
  return std::ranges::all_of(a.outline, [&](const Loop& loop) {
    return std::ranges::any_of(b.outline, [&](const Loop& other) { return is_same_loop(loop, other); });
  });
}

Point middle_of(const ElementCut& cut) {
  Box box;
  for (const Loop& loop : cut.outline) box.extend(box_of(loop));
  return box.center();
}

}  // namespace

Duplicates find_duplicates(const std::vector<ElementCut>& cuts) {
  Duplicates duplicates;
  PointNodes middles(kSamePlace_m);
  std::map<int, std::vector<const ElementCut*>> at;
  for (const ElementCut& cut : cuts) {
    if (!cut.is_cut() || cut.object != cut.element) continue;
    const Point middle = middle_of(cut);
    std::vector<const ElementCut*> near;
    middles.visit_near(middle, [&](int node) { near.insert(near.end(), at[node].begin(), at[node].end()); });
    const auto same = std::ranges::find_if(near, [&](const ElementCut* other) { return is_same_outline(cut, *other); });
    if (same == near.end()) {
      at[middles.add(middle)].push_back(&cut);
      continue;
    }
    duplicates.kept[cut.element->id] = (*same)->element->id;
    duplicates.ids[(*same)->element->id].push_back(cut.element->id);
  }
  return duplicates;
}

}  // namespace opal::ifc_importer
