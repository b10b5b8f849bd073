#include "dxf_scan.hpp"

#include "dxf_clips.hpp"
#include "dxf_encoding.hpp"

#include <opal/common/error.hpp>
#include <opal/common/file_start.hpp>
#include <opal/common/number_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace opal::dxf_importer {
namespace {

constexpr std::uintmax_t kMaxBytes = 256u << 20;
constexpr std::size_t kShownCharacters = 40;
// Zero bytes and control-Z at the end, as old programs fill a file up.
constexpr std::string_view kPadding{"\0\x1A \t\r\n", 6};

std::string read_text(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw MapError(path + ": is no file that can be read");
  if (std::filesystem::file_size(path, error) > kMaxBytes)
    throw MapError(path + ": larger than 256 MiB, expected a plan of one storey");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw MapError(path + ": cannot be read");
  if (text.str().empty()) throw MapError(path + ": is empty, expected a DXF drawing");
  return text.str();
}

/// Drawings of another format, by their first bytes.
void check_format(const std::string& path, const std::string& text) {
  if (text.starts_with("AutoCAD Binary DXF"))
    throw MapError(path + ": is a binary DXF, expected the text format (save as ASCII DXF)");
  if (text.starts_with("AC10")) throw MapError(path + ": is a DWG drawing, expected DXF (save as DXF)");
}

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// As it may stand in a message: short, and without bytes that are no text.
std::string shown(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text.substr(0, kShownCharacters)) quoted += c >= ' ' && c < 127 ? c : '?';
  return quoted + (text.size() > kShownCharacters ? "...\"" : "\"");
}

class Pairs {
 public:
  Pairs(const std::string& path, const std::string& text) : path_(path), text_(text) {
    erase_byte_order_mark(text_);
    text_.erase(text_.find_last_not_of(kPadding) + 1);
    text_ += '\n';
  }

  [[noreturn]] void fail(const std::string& complaint) const { fail_at(line_, complaint); }
  [[noreturn]] void fail_at(int line, const std::string& complaint) const {
    throw MapError(fmt::format("{}:{}: {}", path_, line, complaint));
  }

  /// @throws MapError at the end of the file: that comes after the record EOF only.
  DxfPair next() {
    DxfPair pair;
    const std::string code = line();
    const auto number = parse_number<int>(code);
    if (!number || *number < -5 || *number > 1071) fail(shown(code) + ", expected a group code from -5 to 1071");
    pair.code = *number;
    pair.value = line();
    pair.line = line_;
    return pair;
  }

  bool is_at_end() const { return at_ >= text_.size(); }

  /// Lines from here on that are not blank.
  int lines_left() {
    int lines = 0;
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      lines += !trimmed(text_.substr(at_, end - at_)).empty();
      at_ = end + 1;
    }
    return lines;
  }

 private:
  std::string line() {
    if (at_ >= text_.size()) fail("the file ends here, expected EOF: it was cut off");
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string line = trimmed(text_.substr(at_, end - at_));
    at_ = end + 1;
    ++line_;
    if (line.find('\0') != std::string::npos) fail("holds a zero byte, expected text");
    return line;
  }

  const std::string& path_;
  std::string text_;
  std::size_t at_ = 0;
  int line_ = 0;
};

class Scanner {
 public:
  Scanner(const std::string& path, const std::string& text) : pairs_(path, text) {}

  DxfScan run() {
    advance();
    while (!is_record("EOF")) pair_.code == 9 ? rest_of_header() : section();
    if (!has_entities_) pairs_.fail("the file has no section ENTITIES, expected a drawing");
    scan_.lines_after_end = pairs_.lines_left();
    return std::move(scan_);
  }

 private:
  void advance() {
    do pair_ = pairs_.next();
    while (pair_.code == 999);  // comments
  }
  bool is_record(const char* type) const { return pair_.code == 0 && pair_.value == type; }

  void section() {
    if (!is_record("SECTION")) pairs_.fail(shown(pair_.value) + ", expected 0 SECTION or 0 EOF");
    advance();
    if (pair_.code != 2) pairs_.fail("a section without a name, expected the code 2");
    const std::string name = pair_.value;
    advance();
    if (name == "HEADER") header();
    if (name != "ENTITIES" && name != "BLOCKS" && name != "TABLES") return skip(name);
    std::vector<DxfRecord> records = records_of(name);
    if (name == "ENTITIES") {
      has_entities_ = true;
      std::move(records.begin(), records.end(), std::back_inserter(scan_.entities));
    } else if (name == "TABLES") {
      layers(records);
    } else {
      blocks(std::move(records));
    }
    advance_over_end();
  }

  /// After a section; where the file ends there, and the entities are whole, nothing of the plan is missing.
  void advance_over_end() {
    scan_.lacks_end = has_entities_ && pairs_.is_at_end();
    if (scan_.lacks_end)
      pair_ = {0, "EOF", pair_.line};
    else
      advance();
  }

  void expect_inside(const std::string& name) const {
    if (is_record("SECTION") || is_record("EOF")) pairs_.fail("section " + name + " has no end, expected 0 ENDSEC");
  }

  /// Over a section that is no part of the plan: objects, the picture of the drawing, what later releases add.
  void skip(const std::string& name) {
    DxfClips clips;
    for (; !is_record("ENDSEC"); advance()) {
      expect_inside(name);
      if (name == "OBJECTS") clips.take(pair_);
    }
    scan_.clips += clips.count();
    for (std::string& owner : clips.owners()) scan_.clipped.push_back(std::move(owner));
    advance_over_end();
  }

  /// Up to the section's end.
  std::vector<DxfRecord> records_of(const std::string& name) {
    std::vector<DxfRecord> records;
    while (!is_record("ENDSEC")) {
      expect_inside(name);
      if (pair_.code == 0)
        records.push_back({pair_.value, pair_.line, {}});
      else if (records.empty())
        pairs_.fail(fmt::format("code {} at the begin of section {}, expected 0", pair_.code, name));
      else
        records.back().pairs.push_back(pair_);
      advance();
    }
    return records;
  }

  void header() {
    std::string variable;
    for (; pair_.code != 0; advance()) {
      if (pair_.code == 9) variable = pair_.value;
      if (variable != "$INSUNITS" || pair_.code != 70) continue;
      scan_.insunits = parse_number<int>(pair_.value);
      if (!scan_.insunits) pairs_.fail(shown(pair_.value) + " for $INSUNITS, expected an integer");
    }
  }

  /// Some programs end the header, and go on with its variables up to a second end.
  void rest_of_header() {
    header();
    if (!is_record("ENDSEC")) pairs_.fail(shown(pair_.value) + ", expected 0 ENDSEC after variables of the header");
    advance();
  }

  void layers(const std::vector<DxfRecord>& records) {
    for (const DxfRecord& record : records) {
      if (record.type != "LAYER" || record.text(2).empty()) continue;
      const std::string colour = record.text(62);
      const std::string flags = record.text(70, "0");
      scan_.layers[record.text(2)] = {(std::atoi(flags.c_str()) & 1) != 0, colour.starts_with('-')};
    }
  }

  void blocks(std::vector<DxfRecord> records) {
    const DxfRecord* open = nullptr;
    for (const DxfRecord& record : records) {
      const bool begins = record.type == "BLOCK", is_inside = open != nullptr;
      if (begins == is_inside)
        pairs_.fail_at(record.line,
                       shown(record.type) + ", expected " + (is_inside ? "ENDBLK" : "BLOCK") + " before it");
      if (begins) open = &record;
      if (record.type == "ENDBLK") open = nullptr;
    }
    if (open != nullptr) pairs_.fail_at(open->line, "this block has no end, expected ENDBLK");
    std::move(records.begin(), records.end(), std::back_inserter(scan_.blocks));
  }

  Pairs pairs_;
  DxfPair pair_;
  DxfScan scan_;
  bool has_entities_ = false;
};

}  // namespace

double DxfPair::real() const {
  const std::string_view text = value;
  return parse_number<double>(text.substr(text.starts_with('+') ? 1 : 0)).value_or(0);
}

const DxfPair* DxfRecord::find(int code) const {
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const DxfPair& pair) { return pair.code == code; });
  return found == pairs.end() ? nullptr : &*found;
}

std::string DxfRecord::text(int code, const std::string& otherwise) const {
  const DxfPair* pair = find(code);
  return pair == nullptr ? otherwise : pair->value;
}

double DxfRecord::real(int code, double otherwise) const {
  const DxfPair* pair = find(code);
  return pair == nullptr ? otherwise : pair->real();
}

DxfScan scan_dxf(const std::string& path) {
  const std::string text = read_text(path);
  check_format(path, text);
  return Scanner(path, as_utf8(text)).run();
}

}  // namespace opal::dxf_importer
