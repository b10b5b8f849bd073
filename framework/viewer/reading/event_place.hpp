#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace opal {

using Event = nlohmann::ordered_json;

/// A value inside an event that knows where it stands, so that an error can say so. Everything that is read
/// through it is checked; errors are EventError "POINTER: what was found, what was expected". Lives no longer
/// than the event.
class EventPlace {
 public:
  explicit EventPlace(const Event& event) : value_(&event) {}

  EventPlace member(const char* name) const;
  /// nullopt if it is absent or null.
  std::optional<EventPlace> find(const char* name) const;

  std::size_t elements() const;  ///< of an array
  EventPlace element(std::size_t index) const;
  /// Calls `visit(const std::string& name, const EventPlace& value)` for each member of an object.
  template <class Visit>
  void for_each_member(Visit visit) const {
    require_object();
    for (const auto& [name, value] : value_->items()) visit(name, step({name.c_str(), 0}, value));
  }

  double number(double least, double most) const;
  double coordinate() const;  ///< [m], at most 1e6 from the origin
  double stamp_s() const;
  double probability() const;  ///< null: 0
  double nat() const;          ///< null (no number): kWorst_nat
  int count() const;           ///< an integer >= 0
  bool flag() const;
  bool is_null() const { return value_->is_null(); }
  /// What things are referred to by: ids, types, scorers. At most 1000 bytes.
  const std::string& name() const;
  /// Words for people; cut if they are very long.
  std::string sentence() const;

  Pose2 pose() const;
  std::vector<Point> points() const;  ///< [x, y, x, y, ...]
  Geometry geometry() const;          ///< of an object that has one of the members which name a geometry
  /// The id of something that there is.
  template <class Of>
  Of id() const {
    return Of(count());
  }
  /// The same; -1: of none.
  template <class Of>
  Of id_or_none() const {
    return Of(number_of_id());
  }
  /// An array of them.
  template <class Of>
  std::vector<Of> ids() const {
    std::vector<Of> ids;
    for (std::size_t k = 0; k < elements(); ++k) ids.push_back(element(k).id_or_none<Of>());
    return ids;
  }

  [[noreturn]] void fail(const std::string& expected) const;

  static constexpr double kFarthest_m = 1e6;
  static constexpr double kWorst_nat = -1e6;
  /// Deeper than any event; a hostile line costs no stack.
  static constexpr std::size_t kDeepest = 12;

 private:
  struct Step {
    const char* name = nullptr;  ///< of a member; null: an element
    std::size_t index = 0;
  };

  EventPlace step(const Step& next, const Event& value) const;
  void require_object() const;
  void require_array(std::size_t size, const char* expected) const;
  int number_of_id() const;
  double coordinate(std::size_t index) const;
  double angle(std::size_t index) const;

  const Event* value_;
  std::array<Step, kDeepest> steps_{};
  std::size_t depth_ = 0;
};

}  // namespace opal
