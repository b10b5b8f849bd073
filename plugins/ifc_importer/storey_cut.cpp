#include "storey_cut.hpp"

#include "body_cut.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace opal::ifc_importer {
namespace {

using Kind = Treatment::Kind;

// Jambs, linings and mullions are narrower than this share of a door's width; leaves and panes are wider.
constexpr double kFrameShare = 0.35;
// A hole in a loop within a frame is nothing that anybody sees.
constexpr double kSmallest_m2 = 1e-6;

class StoreyCut {
 public:
  StoreyCut(const Building& building, const Classes& classes, double height_m)
      : building_(building), classes_(classes), height_m_(height_m) {
    for (const Element& element : building.elements) by_id_[element.id] = &element;
  }

  std::vector<ElementCut> run() const {
    std::vector<ElementCut> cuts;
    for (const Element& element : building_.elements) cuts.push_back(cut_of(element));
    return cuts;
  }

 private:
  ElementCut cut_of(const Element& element) const {
    ElementCut result;
    result.element = &element;
    result.treatment = classes_.of(element);
    result.object = &object_of(element, result.treatment);
    const Span span = span_of(element.bodies);
    result.is_within_reach = span.low_m <= height_m_ && height_m_ < span.high_m;
    for (const std::string& trouble : element.troubles)
      result.trouble += (result.trouble.empty() ? "" : "; ") + trouble;
    if (!result.is_within_reach) return result;
    try {
      cut_into(element, result);
    } catch (const OpenSurface& open) {
      result.trouble += (result.trouble.empty() ? "" : "; ") + std::string(open.what());
    }
    return result;
  }

  /// Parts of walls, stairs, ... are no objects of their own; doors and windows always are.
  const Element& object_of(const Element& element, Treatment& treatment) const {
    const Element* object = &element;
    for (int depth = 0; depth < 10 && !object->whole.empty(); ++depth) {
      const auto whole = by_id_.find(object->whole);
      if (whole == by_id_.end() || whole->second->is_a("IfcElementAssembly")) break;
      object = whole->second;
    }
    // NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter): an element of the model, which outlives the cut
    if (object == &element || treatment.kind == Kind::filling) return element;
    const Treatment of_whole = classes_.of(*object);
    if (of_whole.kind == Kind::left_out || element.is_a("IfcBuildingElementPart")) treatment = of_whole;
    treatment.type = of_whole.type;
    return *object;
  }

  void cut_into(const Element& element, ElementCut& result) const {
    const Region openings = openings_of(element, *result.object);
    result.outline = border_of(without(cut(element.bodies, height_m_), openings));
    if (result.treatment.kind == Kind::glass) result.unseen = result.outline;
    if (result.treatment.kind == Kind::solid) result.solid = result.outline;
    if (result.treatment.kind == Kind::filling) divide_filling(element, result);
  }

  static Region without(Region region, const Region& openings) {
    if (openings.kind == Region::Kind::nothing || region.kind == Region::Kind::nothing) return region;
    return combined(Region::Kind::subtract, {std::move(region), openings});
  }

  Region openings_of(const Element& element, const Element& object) const {
    std::vector<Region> regions;
    for (const Element* owner : std::set{&element, &object})
      for (const Opening& opening : owner->openings)
        if (Region region = cut(opening.bodies, height_m_); region.kind != Region::Kind::nothing)
          regions.push_back(std::move(region));
    return combined(Region::Kind::unite, std::move(regions));
  }

  /// Leaf and frame are bodies of their own, or at least loops of their own.
  void divide_filling(const Element& element, ElementCut& result) const {
    const auto [low, high] = extent(result.outline, element.along);
    result.width_m = std::max(0.0, high - low);
    std::vector<Loop> frame;
    for (const Body& body : element.bodies)
      for (Loop& loop : border_of(cut(body, height_m_))) {
        const auto [from, to] = extent({loop}, element.along);
        const bool is_frame = to - from < kFrameShare * result.width_m && std::abs(area_m2(loop)) > kSmallest_m2;
        (is_frame ? frame : result.unseen).push_back(std::move(loop));
      }
    std::vector<Region> parts;
    for (const Loop& loop : frame) parts.push_back(inside_of(std::vector<Loop>{loop}));
    result.solid = border_of(combined(Region::Kind::unite, std::move(parts)));
  }

  static std::pair<double, double> extent(const std::vector<Loop>& loops, const Point& along) {
    double low = 1e9, high = -1e9;
    for (const Loop& loop : loops)
      for (const Point& p : loop) low = std::min(low, along.dot(p)), high = std::max(high, along.dot(p));
    return {low, high};
  }

  const Building& building_;
  const Classes& classes_;
  double height_m_;
  std::unordered_map<std::string, const Element*> by_id_;
};

}  // namespace

std::vector<ElementCut> cut_storey(const Building& building, const Classes& classes, double height_m) {
  return StoreyCut(building, classes, height_m).run();
}

}  // namespace opal::ifc_importer
