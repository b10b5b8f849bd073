#pragma once

#include <catch2/catch.hpp>

#include <string>

namespace opal {

/// What a call is refused with; "accepted" if it is not refused. Other exceptions than Refusal pass.
template <class Refusal, class Call>
std::string refused_with(const Call& call) {
  try {
    call();
  } catch (const Refusal& error) {
    return error.what();
  }
  return "accepted";
}

/// The same after the file's name, with which the message must begin.
template <class Refusal, class Call>
std::string refused_with(const Call& call, const std::string& file) {
  const std::string message = refused_with<Refusal>(call);
  if (message == "accepted") return message;
  REQUIRE_THAT(message, Catch::StartsWith(file + ": "));
  return message.substr(file.size() + 2);
}

}  // namespace opal
