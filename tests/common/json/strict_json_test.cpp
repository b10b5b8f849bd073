#include "tests/kit/refusal.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/strict_json.hpp>

#include <catch2/catch.hpp>

#include <cstdio>
#include <string>

namespace {

using Catch::Matchers::Contains;
using nlohmann::json;
using opal::JsonError;
using opal::JsonLimits;
using opal::parse_json;

/// The message with which the text is refused; fails the test if it is not.
std::string refusal(const std::string& text, const JsonLimits& limits = {}) {
  const std::string message = opal::refused_with<JsonError>([&] { parse_json(text, "a.json", limits); });
  if (message == "accepted") FAIL("accepted: " << text.substr(0, 200));
  return message;
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("strict JSON keeps values as they are written") {
  const std::string text = R"({"a": [1, -2, 2.5, 1e3, true, false, null, "\u00e9\ud83d\ude00"], "": {}, "b": []})";
  CHECK(parse_json(text, "a.json") == json::parse(text));
  CHECK(parse_json(" 7 \n", "a.json") == 7);
  CHECK(parse_json("18446744073709551615", "a.json") == 18446744073709551615u);
}

TEST_CASE("a duplicate key is refused with its pointer") {
  CHECK(refusal(R"({"a": 1, "a": 1})") == "a.json: /a: this key stands twice in one object, expected once");
  CHECK_THAT(refusal(R"({"list": [0, {}, {"x/y~z": 1, "b": {"x/y~z": 1}, "x/y~z": 2}]})"),
             Contains("a.json: /list/2/x~1y~0z: "));
  CHECK_THAT(refusal(R"({"\u0061": 1, "a": 2})"), Contains("/a: "));
  CHECK_NOTHROW(parse_json(R"([{"a": 1}, {"a": 1}, {"a": {"a": 1}}])", "a.json"));
}

TEST_CASE("text that is not UTF-8 is refused") {
  const std::string bad =
      GENERATE(std::string("\"\xff\""), std::string("\"\xc0\xaf\""), std::string("\"\xed\xa0\x80\""),
               std::string("\"\xf4\x90\x80\x80\""), std::string("\"\xe2\x82\""), std::string("\"\\ud800\""),
               std::string("{\"\x80\": 1}"));
  CHECK_THAT(refusal(bad), Contains("a.json: line 1, column "));
}

TEST_CASE("numbers that are not finite are refused") {
  CHECK_THAT(refusal("[1, 1e999]"), Contains("1e999") && Contains("expected a finite number"));
  CHECK_THAT(refusal("-1e999"), Contains("line 1, column "));
  for (const char* text : {"NaN", "Infinity", "-Infinity", "[nan]", "[1e]", "[01]", "[+1]", "[.5]", "[0x1]"})
    CHECK_THAT(refusal(text), Contains("syntax error"));
}

TEST_CASE("what follows the value is refused") {
  for (const char* text : {"{} x", "{}{}", "1 2", "[1],", "null\n]"})
    CHECK_THAT(refusal(text), Contains("expected end of input"));
  CHECK_THAT(refusal(std::string("{}\0 garbage", 11)), Contains("NUL"));
}

TEST_CASE("text that ends early is refused at its end") {
  const std::string whole = R"({"a": [1, {"b": "text"}], "c": null})";
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_THAT(refusal(whole.substr(0, size)), Contains("line 1, column "));
  CHECK_THAT(refusal(""), Contains("no content"));
}

TEST_CASE("a syntax error tells line and column, what was found and what was expected") {
  CHECK_THAT(refusal("{\n  \"a\": 1,\n  b: 2\n}"), Contains("a.json: line 3, column 3: ") &&
                                                       Contains("invalid literal") &&
                                                       Contains("expected string literal"));
}

TEST_CASE("depth is limited without using the stack") {
  JsonLimits limits;
  limits.depth = 3;
  CHECK_NOTHROW(parse_json("[[[1]]]", "a.json", limits));
  CHECK_THAT(refusal("[1, [2, 3, {\"a\": []}]]", limits),
             Contains("a.json: /1/2/a: nested more deeply than expected, at most 3"));
  CHECK_THAT(refusal(repeated("[", 1000000)), Contains("at most 128"));
  CHECK_THAT(refusal(repeated("{\"a\":", 1000000)), Contains("/a/a/a"));
  limits.depth = 100000;
  CHECK_NOTHROW(parse_json(repeated("[", 10000) + repeated("]", 10000), "a.json", limits));
}

TEST_CASE("size is limited") {
  JsonLimits limits;
  limits.bytes = 4;
  CHECK_NOTHROW(parse_json("1234", "a.json", limits));
  CHECK_THAT(refusal("12345", limits), Contains("at most 4"));
}

TEST_CASE("a file is read whole, and named when it cannot be") {
  const opal::TemporaryFolder folder;
  const std::string path = folder.write("long.json", R"({"a": )" + repeated(" ", 200000) + "[1]}");
  CHECK(opal::read_json(path) == json{{"a", json::array({1})}});
  JsonLimits limits;
  limits.bytes = 1000;
  CHECK_THROWS_WITH(opal::read_json(path, limits), Contains(path) && Contains("at most 1000"));
  std::remove(path.c_str());
  CHECK_THROWS_WITH(opal::read_json(path), Contains(path) && Contains("cannot be opened"));
  CHECK_THROWS_AS(opal::read_json("/"), JsonError);
}
