#include <opal/common/id.hpp>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <type_traits>
#include <unordered_set>
#include <vector>

using namespace opal;

namespace {

using RoomId = Id<struct Room>;
using DoorId = Id<struct Door>;

template <class A, class B>
concept CanBeCompared = requires(A a, B b) {
  a == b;
}
|| requires(A a, B b) { a < b; };

template <class A, class B>
concept CanBeAdded = requires(A a, B b) {
  a + b;
}
|| requires(A a, B b) { a - b; }
|| requires(A a, B b) { a += b; };

template <class A>
concept CanBeCounted = requires(A a) {
  ++a;
}
|| requires(A a) { a++; };

template <class A>
concept CanIndex = requires(A a, std::vector<int> list) {
  list[a];
};

template <class A>
concept CanBeTested = std::is_convertible_v<A, bool> || std::is_constructible_v<bool, A>;

// Two kinds cannot be mixed up.
static_assert(!std::is_convertible_v<RoomId, DoorId> && !std::is_constructible_v<DoorId, RoomId>);
static_assert(!std::is_assignable_v<DoorId&, RoomId> && !CanBeCompared<RoomId, DoorId>);
static_assert(CanBeCompared<RoomId, RoomId>);

// An id is no number, and a number is no id.
static_assert(!std::is_convertible_v<int, RoomId> && !std::is_convertible_v<RoomId, int>);
static_assert(std::is_constructible_v<RoomId, int> && std::is_constructible_v<RoomId, std::size_t>);
static_assert(!std::is_constructible_v<RoomId, double> && !std::is_constructible_v<RoomId, bool>);
static_assert(!std::is_assignable_v<RoomId&, int> && !CanBeCompared<RoomId, int>);
static_assert(!CanBeAdded<RoomId, int> && !CanBeAdded<RoomId, RoomId> && !CanBeCounted<RoomId>);
static_assert(!CanIndex<RoomId> && !CanBeTested<RoomId>);

// It costs what its number costs.
static_assert(std::is_trivially_copyable_v<RoomId> && sizeof(RoomId) == 4 && alignof(RoomId) == alignof(int));

}  // namespace

TEST_CASE("an id that was never given is that of none, and goes before all others") {
  CHECK_FALSE(RoomId().exists());
  CHECK(RoomId() == RoomId(-1));
  CHECK(RoomId(0).exists());
  std::vector<RoomId> ids{RoomId(7), RoomId(), RoomId(0)};
  std::sort(ids.begin(), ids.end());
  CHECK(ids == std::vector<RoomId>{RoomId(), RoomId(0), RoomId(7)});
}

TEST_CASE("ids are counted one by one") {
  CHECK(RoomId().next() == RoomId(0));
  CHECK(RoomId(4).next() == RoomId(5));
}

TEST_CASE("messages, JSON and tables know an id by its number") {
  std::ostringstream text;
  text << RoomId(12);
  CHECK(text.str() == "12");
  CHECK(to_string(RoomId()) == "-1");
  const nlohmann::json json{{"room", RoomId(12)}, {"none", RoomId()}, {"all", std::vector{RoomId(3), RoomId(4)}}};
  CHECK(json.dump() == R"({"all":[3,4],"none":-1,"room":12})");
  CHECK(json["room"].get<RoomId>() == RoomId(12));
  CHECK_THROWS(nlohmann::json("12").get<RoomId>());
  const std::unordered_set<RoomId> known{RoomId(1), RoomId(1), RoomId(2)};
  CHECK(known.size() == 2);
}
