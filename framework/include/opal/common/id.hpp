#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>

namespace opal {

/// Says which one of a kind of things: an id that was given, or a position in a list. Ids of two kinds do not convert
/// into each other, and an id is no number to calculate with: whoever confuses two of them is told by the compiler.
/// Files and events hold the number, and -1 for none.
/// @tparam Kind  what it is the id of; may be incomplete.
template <class Kind>
class Id {
 public:
  /// Of none.
  constexpr Id() = default;
  /// @param number  -1: none.
  template <std::integral Number>
  requires(!std::same_as<Number, bool>) constexpr explicit Id(Number number) : number_(static_cast<int>(number)) {}

  constexpr bool exists() const { return number_ >= 0; }  ///< false: it is the id of none
  constexpr int number() const { return number_; }        ///< for files and lists; -1: none
  constexpr Id next() const { return Id(number_ + 1); }   ///< of the thing that is counted after this one

  /// In order of the numbers; none goes first.
  friend constexpr auto operator<=>(Id, Id) = default;
  /// Writes the number.
  friend std::ostream& operator<<(std::ostream& out, Id id) { return out << id.number_; }
  /// The number, for messages.
  friend std::string to_string(Id id) { return std::to_string(id.number_); }
  /// JSON holds the number.
  template <class Json>
  friend void to_json(Json& json, const Id& id) {
    json = id.number_;
  }
  /// JSON holds the number.
  template <class Json>
  friend void from_json(const Json& json, Id& id) {
    id.number_ = json.template get<int>();
  }

 private:
  int number_ = -1;
};

}  // namespace opal

/// @cond  ids are keys of tables: the hash is that of the number
template <class Kind>
struct std::hash<opal::Id<Kind>> {
  std::size_t operator()(const opal::Id<Kind>& id) const noexcept { return std::hash<int>{}(id.number()); }
};
/// @endcond
