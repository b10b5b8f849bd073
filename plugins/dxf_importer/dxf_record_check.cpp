#include "dxf_record_check.hpp"

#include <opal/common/error.hpp>
#include <opal/common/number_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace opal::dxf_importer {
namespace {

// Farther than the Earth is large, in any unit.
constexpr double kMaxReal = 1e12;
constexpr long kMaxVertices = 1'000'000;

struct Codes {
  std::vector<int> once;
  std::vector<int> at_most_once;
};

const std::map<std::string, Codes, std::less<>>& understood() {
  static const std::map<std::string, Codes, std::less<>> kTypes{
      {"LINE", {{10, 20, 11, 21}, {8, 30, 31}}},
      {"CIRCLE", {{10, 20, 40}, {8, 30}}},
      {"ARC", {{10, 20, 40, 50, 51}, {8, 30}}},
      {"LWPOLYLINE", {{90}, {8, 38, 43, 70}}},
      {"POLYLINE", {{}, {8, 66, 70}}},
      {"ELLIPSE", {{10, 20, 11, 21, 40, 41, 42}, {8, 30, 31, 230}}},
      {"SPLINE", {{71, 72, 73}, {8, 70, 74, 230}}},
      {"MLINE", {{40, 70, 71, 72, 73}, {8, 230}}},
      {"INSERT", {{2, 10, 20}, {8, 30, 41, 42, 43, 44, 45, 50, 66, 70, 71}}},
      {"SOLID", {{10, 20, 11, 21, 12, 22}, {8, 13, 23}}},
      {"3DFACE", {{10, 20, 11, 21, 12, 22}, {8, 13, 23, 30, 31, 32, 33, 70}}},
      {"TRACE", {{10, 20, 11, 21, 12, 22}, {8, 13, 23}}},
      {"HATCH", {{91}, {8}}},
      {"VERTEX", {{10, 20}, {8, 30, 42, 70}}},
  };
  return kTypes;
}

bool is_real(int code) {
  return (code >= 10 && code < 60) || (code >= 110 && code < 150) || (code >= 210 && code < 240);
}
bool is_integer(int code) { return (code >= 60 && code < 80) || (code >= 90 && code < 100); }

class RecordCheck {
 public:
  RecordCheck(const std::string& path, const DxfRecord& record) : path_(path), record_(record) {}

  void run() const {
    for (const DxfPair& pair : record_.pairs) {
      if (is_real(pair.code)) check_real(pair);
      if (is_integer(pair.code)) integer(pair);
    }
    const Codes& codes = understood().at(record_.type);
    for (const int code : codes.once)
      if (count(code) != 1)
        fail(record_.line, code, count(code) == 0 ? "no" : fmt::format("{} times", count(code)), "one");
    for (const int code : codes.at_most_once)
      if (count(code) > 1) fail(record_.line, code, fmt::format("{} times", count(code)), "one at most");
    if (record_.type == "LWPOLYLINE") check_vertices();
    if (record_.type == "SPLINE") check_counts({{72, 40}, {73, 10}, {73, 20}});
    if (record_.type == "MLINE") check_counts({{72, 11}, {72, 21}, {72, 13}, {72, 23}});
  }

 private:
  long count(int code) const {
    return std::ranges::count_if(record_.pairs, [&](const DxfPair& pair) { return pair.code == code; });
  }

  [[noreturn]] void fail(int line, int code, const std::string& found, const std::string& expected) const {
    throw MapError(fmt::format("{}:{}: {}: {} code {}, expected {}", path_, line, record_.type, found, code, expected));
  }

  void check_real(const DxfPair& pair) const {
    std::string_view text = pair.value;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto value = parse_number<double>(text);
    if (!value || !std::isfinite(*value) || std::abs(*value) > kMaxReal)
      fail(pair.line, pair.code, "\"" + pair.value.substr(0, 40) + "\" for", "a number of at most 1e12");
  }

  long integer(const DxfPair& pair) const {
    const auto value = parse_number<int>(pair.value);
    if (!value) fail(pair.line, pair.code, "\"" + pair.value.substr(0, 40) + "\" for", "an integer");
    return *value;
  }

  /// The first code of each pair counts how often the second is there.
  void check_counts(const std::vector<std::pair<int, int>>& counts) const {
    for (const auto& [number, counted] : counts)
      if (const DxfPair& stated = *record_.find(number); integer(stated) != count(counted))
        fail(stated.line, counted, std::to_string(count(counted)) + " times",
             stated.value + ", as code " + std::to_string(number) + " says");
  }

  /// Code 90 counts the vertices; each is an x (10) with its y (20) right after it.
  void check_vertices() const {
    const DxfPair& number = *record_.find(90);
    const long stated = integer(number);
    if (stated < 0 || stated > kMaxVertices)
      fail(number.line, 90, "\"" + number.value + "\" for", "0 to 1000000 vertices");
    if (count(10) != stated || count(20) != stated)
      fail(number.line, 90, fmt::format("{} x and {} y of vertices beside", count(10), count(20)),
           number.value + " of both");
    for (std::size_t k = 0; k < record_.pairs.size(); ++k)
      if (record_.pairs[k].code == 10 && (k + 1 == record_.pairs.size() || record_.pairs[k + 1].code != 20))
        fail(record_.pairs[k].line, 10, "a vertex without y after its", "code 20");
  }

  const std::string& path_;
  const DxfRecord& record_;
};

}  // namespace

bool is_understood(const std::string& type) { return type != "VERTEX" && understood().contains(type); }

void check_records(const std::string& path, const DxfEntityRecords& entity) {
  RecordCheck(path, entity.head).run();
  for (const DxfRecord& part : entity.parts)
    if (part.type == "VERTEX") RecordCheck(path, part).run();
}

}  // namespace opal::dxf_importer
