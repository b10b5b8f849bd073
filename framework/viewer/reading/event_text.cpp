#include "viewer/reading/event_text.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

namespace opal {
namespace {

/// Wider than any event; a hostile line costs no quadratic time.
constexpr std::size_t kMostMembers = 500;

/// Puts an event together as the parser reads it.
class EventAssembly {
 public:
  Event take() { return std::move(event_); }

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(Event::number_integer_t value) { return add(value); }
  bool number_unsigned(Event::number_unsigned_t value) { return add(value); }
  bool number_float(Event::number_float_t value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(Event::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Event::object()); }
  bool start_array(std::size_t) { return open(Event::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    auto& members = open_.back()->get_ref<Event::object_t&>();
    if (members.size() >= kMostMembers)
      throw EventError(fmt::format("an object of more than {} members, expected fewer", kMostMembers));
    for (const auto& member : members)
      if (member.first == name) throw EventError("the key '" + name + "' stands twice in one object, expected once");
    // The underlying vector's: ordered_map's own insertion would search a second time.
    members.Event::object_t::Container::emplace_back(std::move(name), nullptr);
    return true;
  }

  bool parse_error(std::size_t byte, const std::string& token, const nlohmann::detail::exception& error) {
    const bool overflow = dynamic_cast<const nlohmann::detail::out_of_range*>(&error) != nullptr;
    throw EventError(fmt::format("column {}: {}, expected {}", byte,
                                 overflow ? "a number too large for a double" : "'" + tail(token) + "'",
                                 overflow ? "a finite number" : "JSON text"));
  }

 private:
  static std::string tail(const std::string& token) {
    constexpr std::size_t kLongest = 40;
    return Event(token.size() <= kLongest ? token : token.substr(token.size() - kLongest))
        .dump(-1, ' ', true, Event::error_handler_t::replace);
  }

  bool add(Event value) {
    place(std::move(value));
    return true;
  }
  bool open(Event empty) {
    if (open_.size() >= EventPlace::kDeepest)
      throw EventError(fmt::format("nested more deeply than expected, at most {} levels", EventPlace::kDeepest));
    open_.push_back(place(std::move(empty)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  Event* place(Event&& value) {
    if (open_.empty()) return &(event_ = std::move(value));
    if (open_.back()->is_object()) {
      Event& member = open_.back()->get_ref<Event::object_t&>().back().second;
      return &(member = std::move(value));
    }
    auto& elements = open_.back()->get_ref<Event::array_t&>();
    elements.push_back(std::move(value));
    return &elements.back();
  }

  Event event_;
  std::vector<Event*> open_;
};

}  // namespace

Event parse_event(std::string_view line) {
  // The parser takes a NUL for the end of the text and would not look at what follows.
  if (const auto nul = line.find('\0'); nul != std::string_view::npos)
    throw EventError("column " + std::to_string(nul + 1) + ": a NUL byte, expected JSON text");
  EventAssembly assembly;
  Event::sax_parse(line.begin(), line.end(), &assembly);
  return assembly.take();
}

}  // namespace opal
