#include "viewer/html/page.hpp"
#include "recorded_run.hpp"

#include <opal/common/error.hpp>

#include <zlib.h>
#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;
using Catch::Contains;

namespace {

Narrator silent() {
  return [](const RunHeader&, const RunFrame&) { return Words{}; };
}

std::string bytes_of(const std::string& base64) {
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char c : base64) {
    static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (c == '=') break;
    group = group << 6 | static_cast<unsigned>(kDigits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xff);
  }
  return bytes;
}

/// Records in base64 of gzip, as lines.
std::vector<std::string> records_of(const std::string& data) {
  std::string packed = bytes_of(data), text(64 << 20, ' ');
  z_stream stream{};
  REQUIRE(inflateInit2(&stream, 15 + 16) == Z_OK);
  stream.next_in = reinterpret_cast<unsigned char*>(packed.data());
  stream.avail_in = static_cast<unsigned>(packed.size());
  stream.next_out = reinterpret_cast<unsigned char*>(text.data());
  stream.avail_out = static_cast<unsigned>(text.size());
  REQUIRE(inflate(&stream, Z_FINISH) == Z_STREAM_END);
  text.resize(stream.total_out);
  inflateEnd(&stream);
  return lines_of(text);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a packed run unpacks to its records") {
  const EventFile file(text_of({50, 10, 12}));
  const PackedRun packed = pack_run(file.path(), "name", 10'000'000, silent);
  CHECK(packed.frames == 50);
  CHECK(packed.reduced.empty());
  const auto records = records_of(packed.data);
  REQUIRE(records.size() == 52);
  CHECK(Event::parse(records[0])["r"] == "run");
  CHECK(Event::parse(records[1])["r"] == "map");
  CHECK(Event::parse(records[51])["keyframe"] == 49);
}

TEST_CASE("a run that would be too large is packed with less detail, and says so") {
  const EventFile file(text_of({150, 80, 60}));
  const std::size_t all = pack_run(file.path(), "", 100'000'000, silent).data.size();
  for (const double share : {0.8, 0.5, 0.3}) {
    const auto limit = static_cast<std::size_t>(share * double(all));
    const PackedRun packed = pack_run(file.path(), "", limit, silent);
    CHECK(packed.data.size() <= limit);
    CHECK_FALSE(packed.reduced.empty());
    const auto records = records_of(packed.data);
    CHECK(records.size() == 152);
    CHECK(Event::parse(records[0])["reduced"] == Event(packed.reduced));
  }
  CHECK(pack_run(file.path(), "", 100, silent).data.size() > 100);  // the least there is
}

TEST_CASE("what is missing at the end of a run is said at its last update") {
  const std::string whole = text_of({5, 4, 4});
  const EventFile file(whole.substr(0, whole.size() - 10));
  const PackedRun packed = pack_run(file.path(), "", 10'000'000, silent);
  CHECK(packed.frames == 4);
  REQUIRE(packed.notes.size() == 2);
  const Event last = Event::parse(records_of(packed.data).back());
  REQUIRE(last.contains("words"));
  CHECK(last["words"][0] == Event::array({"note", packed.notes[0]}));
}

TEST_CASE("a run without an update is an error") {
  const EventFile file(text_of({0, 1, 1}));
  CHECK_THROWS_WITH(pack_run(file.path(), "", 1000, silent), Contains("holds no update"));
}

TEST_CASE("nothing from a recording becomes markup") {
  const std::string evil = "</script><script>alert(1)</script>\"'<img src=x onerror=alert(2)>";
  auto lines = lines_of(text_of({3, 3, 4}));
  std::string text;
  for (std::string& line : lines) {
    Event event = Event::parse(line);
    if (event["event"] == "run") event["log"] = event["config"] = event["sensor"] = evil;
    if (event["event"] == "start") event["query"] = evil;
    if (event["event"] == "map") event["objects"][0][0] = event["objects"][0][1] = event["name"] = evil;
    if (event["event"] == "pruned") event["reason"] = evil;
    text += event.dump() + '\n';
  }
  const EventFile file(text);
  const auto speaking = [&] { return [&](const RunHeader&, const RunFrame&) { return Words{{evil, evil}}; }; };
  PackedRun run = pack_run(file.path(), evil, 1'000'000, speaking);
  const std::string page = page_of({run});
  CHECK(page.find("<script>alert") == std::string::npos);
  CHECK(page.find("<img") == std::string::npos);
  run.name = "harmless";
  CHECK(count(page, "<script") == count(page_of({run}), "<script"));
  CHECK(page.find("data-name=\"&lt;/script&gt;") != std::string::npos);
}

TEST_CASE("the page runs its own script and style only, and needs no network") {
  const EventFile file(text_of({3, 3, 4}));
  const std::string page =
      page_of({pack_run(file.path(), "a", 1'000'000, silent), pack_run(file.path(), "b", 1'000'000, silent)});
  CHECK_THAT(page, Contains("default-src 'none'"));
  const std::size_t at = page.find("script-src 'nonce-") + 18;
  const std::string nonce = page.substr(at, page.find('\'', at) - at);
  CHECK(nonce.size() == 32);
  CHECK(count(page, "<style nonce=\"" + nonce + "\">") == 1);
  CHECK(count(page, "<script nonce=\"" + nonce + "\">") == 1);
  CHECK(page.find("Content-Security-Policy") < page.find("<style"));
  CHECK(count(page, "class=\"opal-run\"") == 2);
  CHECK(page.find("<!-- opal:") == std::string::npos);
  for (const char* loading : {"src=\"http", "href=\"http", "@import", "url(http"})
    CHECK(page.find(loading) == std::string::npos);
}

TEST_CASE("the same run is the same page") {
  const EventFile file(text_of({20, 5, 8}));
  const auto once = [&] { return page_of({pack_run(file.path(), "a", 1'000'000, silent)}); };
  CHECK(once() == once());
}

TEST_CASE("a live page names where its events come from") {
  CHECK_THAT(live_page("/events"), Contains("<meta name=\"opal-live\" content=\"/events\">"));
  CHECK_THAT(live_page("\"><script>"), !Contains("\"><script>"));
}
