#include <opal/plugin/testing/pattern_contract.hpp>

#include "common/phrases.hpp"
#include "plugin/testing/scene.hpp"
#include "plugin/testing/violations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <limits>
#include <numeric>
#include <random>

namespace opal::testing {
namespace {

using Instance = std::optional<PatternInstance>;
using Selection = std::vector<Feature>;
using Order = std::vector<int>;

/// Random features of the kinds that a template asks for, near enough to each other, at right angles more
/// often than chance would have it.
class RandomSelections {
 public:
  RandomSelections(const PatternShape& shape, const TypeInfo& type)
      : shape_(shape), type_(type), spread_m_(std::clamp(shape.reach_m, 0.5, 10.0)) {}

  Selection next() {
    Selection selection;
    base_heading_rad_ = between(-std::numbers::pi, std::numbers::pi);
    const bool equal_sizes = between(0, 1) < 0.1;
    size_m_ = between(0.05, 1);
    for (std::size_t slot = 0; slot < shape_.slots.size(); ++slot) {
      if (!equal_sizes) size_m_ = between(0.05, 1);
      Feature feature;
      if (!type_.consumes.empty()) feature.type = type_.consumes[std::min(slot, type_.consumes.size() - 1)];
      feature.geometry = geometry(shape_.slots[slot]);
      feature.covariance = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
      if (shape_.slots[slot] == GeometryKind::point || shape_.slots[slot] == GeometryKind::segment)
        feature.covariance(2, 2) = 0;
      selection.push_back(feature);
    }
    return selection;
  }

  Pose2 motion() { return {between(-50, 50), between(-50, 50), between(-std::numbers::pi, std::numbers::pi)}; }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  double heading() {
    if (between(0, 1) < 0.4) return between(-std::numbers::pi, std::numbers::pi);
    return base_heading_rad_ + 0.5 * std::numbers::pi * std::floor(between(0, 4)) + between(-0.02, 0.02);
  }

  Geometry geometry(GeometryKind kind) {
    const Point place(between(-spread_m_, spread_m_) / 2, between(-spread_m_, spread_m_) / 2);
    if (kind == GeometryKind::point) return place;
    if (kind == GeometryKind::circle) return Circle{place, 0.05 + 0.5 * size_m_};
    if (kind == GeometryKind::oriented_point)
      return OrientedPoint{place, heading(), std::numbers::pi * (between(0, 1) < 0.5 ? 0.5 : 1.5) + between(-0.3, 0.3)};
    return Segment{place, place + (0.1 + 6 * size_m_) * unit_vector(heading())};
  }

  PatternShape shape_;
  TypeInfo type_;
  double spread_m_;
  double base_heading_rad_ = 0;
  double size_m_ = 1;
  std::mt19937 random_{20};
};

Selection moved(const Selection& selection, const Pose2& motion) {
  Selection result;
  for (const Feature& feature : selection) result.push_back(transformed(motion, feature));
  return result;
}

class Matching {
 public:
  Matching(const PatternTemplate& pattern, const TypeInfo& type, const PatternTrial& trial)
      : pattern_(pattern), trial_(trial), violations_(type.name), type_(type) {}

  std::vector<std::string> run() {
    violations_.expect_no_throw("being asked for its shape", [&] { shape_ = pattern_.shape(); });
    if (!check_shape()) return violations_.take();
    RandomSelections random(shape_, type_);
    check_degenerate(random.next());
    for (const Selection& selection : trial_.selections) {
      if (!check_selection(selection, random))
        violations_.add("example", "does not match a selection that must form an instance");
    }
    int matched = 0;
    for (int i = 0; i < trial_.random_selections; ++i) matched += check_selection(random.next(), random);
    if (trial_.selections.empty() && matched == 0)
      violations_.add("never", "matches none of " + std::to_string(trial_.random_selections) +
                                   " random selections; give the contract selections that it must match");
    return violations_.take();
  }

 private:
  bool check_shape() {
    if (shape_.slots.empty() || shape_.slots.size() > 5) {
      violations_.add("shape", "asks for " + std::to_string(shape_.slots.size()) + " features, expected 1 to 5");
      return false;
    }
    const bool reaches = std::isfinite(shape_.reach_m) && (shape_.reach_m > 0 || shape_.slots.size() == 1);
    if (!reaches) violations_.add("reach", "has a reach of " + std::to_string(shape_.reach_m) + " m");
    return reaches;
  }

  Instance match(const Selection& selection, const Order& order) const {
    std::vector<const Feature*> features;
    for (const int member : order) features.push_back(&selection[static_cast<std::size_t>(member)]);
    return pattern_.match(features);
  }

  bool fits_slots(const Selection& selection, const Order& order) const {
    for (std::size_t slot = 0; slot < order.size(); ++slot)
      if (kind_of(selection[static_cast<std::size_t>(order[slot])].geometry) != shape_.slots[slot]) return false;
    return true;
  }

  /// The instance in the one order that is accepted; checks that there are not two.
  Instance accepted(const Selection& selection) {
    Instance only;
    if (selection.size() != shape_.slots.size()) {
      violations_.add("arity", "was given a selection of another size than its shape says");
      return only;
    }
    Order order(selection.size());
    std::iota(order.begin(), order.end(), 0);
    do {
      if (!fits_slots(selection, order)) continue;
      Instance instance = match(selection, order);
      if (instance && only)
        violations_.add("orders", "accepts a selection in two orders, expected exactly one: " + summary(selection));
      if (instance) only = std::move(instance);
    } while (std::next_permutation(order.begin(), order.end()));
    return only;
  }

  bool check_selection(const Selection& selection, RandomSelections& random) {
    Instance instance;
    violations_.expect_no_throw("ordinary features: " + summary(selection), [&] {
      instance = accepted(selection);
      check_motion(selection, instance, random.motion());
      if (!instance) return;
      check_instance(*instance, selection);
      check_repeat(selection, *instance);
    });
    return instance.has_value();
  }

  void check_instance(const PatternInstance& instance, const Selection& selection) {
    const std::string of = " of " + summary(selection);
    Order members = instance.members;
    std::sort(members.begin(), members.end());
    Order all(shape_.slots.size());
    std::iota(all.begin(), all.end(), 0);
    if (members != all)
      violations_.add("members", "gives an instance" + of + " whose members are not each feature once");
    if (!is_finite(instance.frame)) violations_.add("frame", "gives an instance" + of + " whose frame is not finite");
    const bool extent = std::isfinite(instance.extent_min_m) && std::isfinite(instance.extent_max_m) &&
                        instance.extent_min_m <= instance.extent_max_m && instance.overhang_m >= 0;
    if (!extent) violations_.add("extent", "gives an instance" + of + " with an impossible extent");
    std::vector<Comparison> comparisons;
    for (const Invariant& invariant : instance.invariants) {
      comparisons.push_back(invariant.comparison);
      if (!std::isfinite(invariant.value)) violations_.add("value", "gives an invariant" + of + " that is not finite");
      if (!(invariant.tolerance >= 0) || !std::isfinite(invariant.tolerance))
        violations_.add("tolerance",
                        "gives an invariant" + of + " with a tolerance of " + std::to_string(invariant.tolerance));
    }
    if (!comparisons_) comparisons_ = comparisons;
    if (comparisons != *comparisons_)
      violations_.add("comparisons", "gives instances with different numbers or comparisons of invariants");
  }

  void check_motion(const Selection& selection, const Instance& instance, const Pose2& motion) {
    const Instance image = accepted(moved(selection, motion));
    const std::string of = summary(selection);
    if (instance.has_value() != image.has_value()) {
      violations_.add("motion", "matches " + of + " in one frame, but not in another");
      return;
    }
    if (!instance) return;
    if (instance->invariants.size() != image->invariants.size()) return;  // found by check_instance
    for (std::size_t k = 0; k < instance->invariants.size(); ++k) {
      const double before = instance->invariants[k].value, after = image->invariants[k].value;
      if (std::abs(before - after) > trial_.tolerance * (1 + std::abs(before)))
        violations_.add("invariant",
                        "has an invariant " + std::to_string(k) + " that a rigid motion changes from " +
                            std::to_string(before) + " to " + std::to_string(after) + ", for " + of +
                            fmt::format(" (allowed: {:g} of its size)", trial_.tolerance),
                        "it is made of coordinates, not of distances and angles between the features");
    }
    check_frame(*instance, *image, motion, of);
  }

  void check_frame(const PatternInstance& instance, const PatternInstance& image, const Pose2& motion,
                   const std::string& of) {
    const Pose2 expected = motion * instance.frame;
    const double turned_rad = angle_between_rad(expected, image.frame);
    const double error_rad = instance.symmetric ? std::min(turned_rad, std::numbers::pi - turned_rad) : turned_rad;
    const double tolerance = 1e2 * trial_.tolerance;  // coordinates are up to 50 m, angles amplify by the reach
    if (distance_m(expected, image.frame) > tolerance || error_rad > tolerance)
      violations_.add("rigid",
                      "has a frame that does not move rigidly with its features, for " + of +
                          fmt::format(" (allowed: {:g} m and rad)", tolerance),
                      "its heading comes from the axes of the map, or from an order of the features that changes");
  }

  void check_repeat(const Selection& selection, const PatternInstance& expected) {
    if (++repeats_ > 20) return;  // a thread each
    const auto agrees = [&] {
      const Instance again = quietly_accepted(selection);
      return again && again->invariants.size() == expected.invariants.size() &&
             std::equal(again->invariants.begin(), again->invariants.end(), expected.invariants.begin(),
                        [](const Invariant& a, const Invariant& b) { return a.value == b.value; });
    };
    auto other = std::async(std::launch::async, agrees);
    const bool here = agrees();
    if (!other.get() || !here)
      violations_.add("repeat", "gives another answer when it is asked again, or from another thread");
  }

  /// Like accepted(), but touches nothing of this object: for other threads.
  Instance quietly_accepted(const Selection& selection) const {
    Order order(selection.size());
    std::iota(order.begin(), order.end(), 0);
    do {
      Instance instance = fits_slots(selection, order) ? match(selection, order) : std::nullopt;
      if (instance) return instance;
    } while (std::next_permutation(order.begin(), order.end()));
    return std::nullopt;
  }

  /// Features that lie upon each other, have no size, or are not numbers.
  void check_degenerate(const Selection& ordinary) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto with = [&](auto&& change) {
      Selection selection = ordinary;
      for (Feature& feature : selection) change(feature);
      return selection;
    };
    const std::vector<std::pair<std::string, Selection>> cases{
        {"features of no size in one place", with([](Feature& f) {
           f.geometry = transformed(Pose2(), f.geometry);
           if (auto* s = std::get_if<Segment>(&f.geometry)) *s = {{1, 1}, {1, 1}};
           if (auto* p = std::get_if<Point>(&f.geometry)) *p = {1, 1};
           if (auto* c = std::get_if<Circle>(&f.geometry)) *c = {{1, 1}, 0};
           if (auto* o = std::get_if<OrientedPoint>(&f.geometry)) *o = {{1, 1}, 0, std::numbers::pi};
         })},
        {"equal features", with([&](Feature& f) {
           if (f.geometry.index() == ordinary.front().geometry.index()) f = ordinary.front();
         })},
        {"features that are not a number", with([&](Feature& f) { f = transformed(Pose2(nan, nan, nan), f); })}};
    for (const auto& each : cases) {
      const auto& name = each.first;  // clang 14 captures no structured bindings
      const auto& selection = each.second;
      violations_.expect_no_throw(name, [&] {
        Order order(selection.size());
        std::iota(order.begin(), order.end(), 0);
        const Instance instance = match(selection, order);
        if (instance) check_finite(*instance, name);
      });
    }
  }

  void check_finite(const PatternInstance& instance, const std::string& name) {
    const auto finite = [](const Invariant& i) { return std::isfinite(i.value) && std::isfinite(i.tolerance); };
    if (!is_finite(instance.frame) || !std::all_of(instance.invariants.begin(), instance.invariants.end(), finite))
      violations_.add("degenerate", "gives an instance with numbers that are not finite for " + name);
  }

  static std::string summary(const Selection& selection) {
    return listed_by(selection, [](const Feature& feature) { return described(feature.geometry); });
  }

  const PatternTemplate& pattern_;
  const PatternTrial& trial_;
  Violations violations_;
  const TypeInfo& type_;
  PatternShape shape_;
  std::optional<std::vector<Comparison>> comparisons_;
  int repeats_ = 0;
};

}  // namespace

std::vector<std::string> pattern_violations(const PatternTemplate& pattern, const TypeInfo& type,
                                            const PatternTrial& trial) {
  return Matching(pattern, type, trial).run();
}

}  // namespace opal::testing
