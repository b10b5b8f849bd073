#include "step_text.hpp"

#include "foreign_letters.hpp"
#include "reference_check.hpp"
#include "side_information.hpp"
#include "step_arguments.hpp"

#include <opal/common/error.hpp>
#include <opal/common/file_start.hpp>
#include <opal/common/letter_case.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace opal::ifc_importer {
namespace {

// A parsed model takes about twenty times the memory of its text.
constexpr std::uintmax_t kMaxBytes = 400'000'000;
constexpr std::string_view kFirst = "ISO-10303-21";
constexpr std::string_view kLast = "END-ISO-10303-21";
constexpr const char* kBegin = "ISO-10303-21;";
constexpr const char* kEnd = "END-ISO-10303-21;";
// Before the first statement, as some programs leave it there.
constexpr std::size_t kMostRubbish = 16;
constexpr std::size_t kHead_bytes = 1u << 16;
// Zero bytes and control-Z at the end, as old programs fill a file up.
constexpr std::string_view kPadding{"\0\x1A \t\r\n", 6};

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Goes through the statements of a STEP text; texts and comments may hold semicolons.
class Statements {
 public:
  /// @param is_cut_off  the text does not end as a whole one does: what has no end is what was cut.
  Statements(std::string& text, const std::string& name, bool is_cut_off)
      : text_(text), name_(name), is_cut_off_(is_cut_off) {}

  /// The next statement without its semicolon; comments in it are blanked out. Empty: there is none, or it is cut off.
  std::string_view next() {
    begin_ = at_;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\'')
        skip_text();
      else if (c == '/' && at_ + 1 < text_.size() && text_[at_ + 1] == '*')
        blank_comment();
      else if (c == ';')
        return trimmed(std::string_view(text_).substr(begin_, at_++ - begin_));
    }
    if (!is_cut_off_ && !trimmed(std::string_view(text_).substr(begin_)).empty())
      fail(begin_, "a statement without an end", "';'");
    return {};
  }

  bool is_at_end() const { return at_ >= text_.size(); }

  /// Of the last statement, also where it is cut off.
  int line() const { return line_of(std::min(text_.find_first_not_of(" \t\r\n", begin_), text_.size())); }

  /// After the last statement.
  void expect_end() const {
    const std::size_t more = text_.find_first_not_of(" \t\r\n", at_);
    if (more != std::string::npos) fail(more, "more text after " + std::string(kEnd), "one model in a file");
  }

  [[noreturn]] void fail(std::size_t at, const std::string& found, const std::string& expected) const {
    throw MapError(fmt::format("{}: line {}: {}, expected {}", name_, line_of(at), found, expected));
  }
  [[noreturn]] void fail(std::string_view statement, const std::string& expected) const {
    std::string found(statement.substr(0, 60));
    for (char& c : found)
      if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
    fail(static_cast<std::size_t>(statement.data() - text_.data()), "'" + found + "'", expected);
  }

 private:
  int line_of(std::size_t at) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at, text_.size()));
    return 1 + static_cast<int>(std::count(text_.begin(), end, '\n'));
  }
  void skip_text() {
    const std::size_t begin = at_;
    for (++at_; at_ < text_.size(); ++at_)
      if (text_[at_] == '\'') return;  // a doubled one begins the next text at once
    if (!is_cut_off_) fail(begin, "a text without an end", "'");
  }
  void blank_comment() {
    const std::size_t begin = at_, end = text_.find("*/", at_ + 2);
    if (end == std::string::npos) {
      if (!is_cut_off_) fail(begin, "a comment without an end", "*/");
      at_ = text_.size();
      return;
    }
    std::fill(text_.begin() + static_cast<std::ptrdiff_t>(begin), text_.begin() + static_cast<std::ptrdiff_t>(end + 2),
              ' ');
    at_ = end + 1;
  }

  std::string& text_;
  const std::string& name_;
  bool is_cut_off_;
  std::size_t at_ = 0, begin_ = 0;
};

int read_number(std::string_view text, std::size_t& at) {
  int number = -1;
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
  if (error != std::errc()) return -1;
  at = static_cast<std::size_t>(end - text.data());
  return number;
}

/// After a text comes a comma or the end of its list; a doubled quote begins the next piece of the same text.
bool may_follow_text(std::string_view text, std::size_t at) {
  while (at < text.size() && is_space(text[at])) ++at;
  return at == text.size() || text[at] == ',' || text[at] == ')' || text[at] == '\'';
}

/// Calls visit(position) for what stands outside of texts; false if the parentheses do not match, or a comma is
/// missing.
template <class Visit>
bool visit_outside_texts(std::string_view text, Visit visit) {
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\'') {
      at = text.find('\'', at + 1);
      if (at == std::string_view::npos || !may_follow_text(text, at + 1)) return false;
      continue;
    }
    depth += (text[at] == '(') - (text[at] == ')');
    if (depth < 0) return false;
    visit(at, depth);
  }
  return depth == 0;
}

StepInstance read_instance(const Statements& statements, std::string_view statement) {
  const char* expected = "an instance such as #12= IFCWALL(...)";
  StepInstance instance;
  std::size_t at = 1;
  instance.number = statement.starts_with('#') ? read_number(statement, at) : -1;
  if (instance.number < 0) statements.fail(statement, expected);
  while (at < statement.size() && (is_space(statement[at]) || statement[at] == '=')) ++at;
  const std::size_t type = at;
  while (at < statement.size() && is_word(statement[at])) ++at;
  instance.type = statement.substr(type, at - type);
  while (at < statement.size() && is_space(statement[at])) ++at;
  if (instance.type.empty() || at >= statement.size() || statement[at] != '(' || statement.back() != ')')
    statements.fail(statement, expected);
  instance.arguments = statement.substr(at + 1, statement.size() - at - 2);
  const bool closed = visit_outside_texts(instance.arguments, [&](std::size_t k, int) {
    if (instance.arguments[k] != '#') return;
    std::size_t number_at = k + 1;
    const int number = read_number(instance.arguments, number_at);
    if (number < 0) statements.fail(statement, "a number after '#'");
    instance.references.push_back(number);
  });
  if (!closed) statements.fail(statement, "arguments with commas between them, and as many ')' as '('");
  const std::string_view first = trimmed(instance.arguments.substr(0, 40));
  if (first.starts_with('\''))
    if (const std::size_t end = first.find('\'', 1); end != std::string_view::npos)
      instance.global_id = first.substr(1, end - 1);
  return instance;
}

/// "IFC4" of FILE_SCHEMA(('IFC4')).
std::string schema_of(std::string_view statement) {
  const std::size_t begin = statement.find('\''), end = statement.find('\'', begin + 1);
  if (begin == std::string_view::npos || end == std::string_view::npos) return "";
  return upper_case_letters(std::string(trimmed(statement.substr(begin + 1, end - begin - 1))));
}

void expect_known(const std::string& schema, const std::string& name) {
  if (!schema.starts_with("IFC2X") && !schema.starts_with("IFC4"))
    throw MapError(name + ": FILE_SCHEMA: '" + schema + "', expected IFC2X, IFC2X2, IFC2X3, IFC4 or IFC4X3");
}

struct Sections {
  std::string schema;
  std::vector<StepInstance> instances;
  bool ends_in_data = false;
};

Sections read_sections(Statements& statements, bool is_cut_off, const std::string& name) {
  Sections sections;
  bool& in_data = sections.ends_in_data;
  for (std::string_view statement = statements.next(); statement != kLast; statement = statements.next()) {
    if (statement.empty() && is_cut_off && statements.is_at_end()) return sections;
    if (statement.empty()) throw MapError(name + ": has an empty statement or ends early, expected " + kEnd);
    if (statement.starts_with("FILE_SCHEMA"))
      sections.schema = schema_of(statement);
    else if (statement == "DATA" || statement.starts_with("DATA("))
      in_data = true;
    else if (statement == "ENDSEC")
      in_data = false;
    else if (in_data)
      sections.instances.push_back(read_instance(statements, statement));
  }
  statements.expect_end();
  return sections;
}

/// Of a file that does not end as it should.
std::string about_end(const Statements& statements, bool ends_in_data) {
  if (!ends_in_data) return fmt::format("doubtful: the file ends without {}, after its data", kEnd);
  return fmt::format(
      "doubtful: the file is cut off in line {}: what it would define from there on is missing, also openings, so that "
      "doors and windows may be closed",
      statements.line());
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

StepText StepText::read(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw MapError(path + ": is no file, expected an IFC model");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > kMaxBytes)
    throw MapError(fmt::format("{}: {} bytes, expected at most {}; export the storeys apart", path, size, kMaxBytes));
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw MapError(path + ": cannot be read");
  return parse(std::move(text).str(), path);
}

StepText StepText::parse(std::string content, const std::string& name) {
  StepText step;
  step.text_ = with_codes(std::move(content));
  step.text_.erase(step.text_.find_last_not_of(kPadding) + 1);
  const bool is_cut_off = !step.text_.ends_with(kEnd);
  Statements statements(step.text_, name, is_cut_off);
  if (const std::string_view first = statements.next();
      !first.ends_with(kFirst) || first.size() > kFirst.size() + kMostRubbish)
    throw MapError(name + ": does not begin with " + kBegin + ", expected an IFC model (STEP)");
  Sections sections = read_sections(statements, is_cut_off, name);
  const bool ends_in_data = sections.ends_in_data;
  step.schema_ = std::move(sections.schema);
  step.instances_ = std::move(sections.instances);
  expect_known(step.schema_, name);
  if (ends_in_data && !is_cut_off) throw MapError(name + ": the data section has no end, expected ENDSEC");
  if (step.instances_.empty())
    throw MapError(name + ": has no instances, expected a building model" +
                   (is_cut_off ? "; the file is cut off" : ""));
  step.is_cut_off_ = ends_in_data;
  step.left_out_ = leave_out_unsound(step.instances_, name, ends_in_data);
  if (is_cut_off) step.left_out_.insert(step.left_out_.begin(), about_end(statements, ends_in_data));
  check_references(step.instances_, name);
  return step;
}

std::string StepText::for_parser() const {
  const bool is_4x3 = schema_.starts_with("IFC4X");
  std::string text = std::string(kBegin) +
                     "\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('" +
                     (schema_.starts_with("IFC2X") ? "IFC2X3" : "IFC4") + "'));\nENDSEC;\nDATA;\n";
  text.reserve(text_.size() + text.size());
  for (const StepInstance& instance : instances_) {
    text.append("#").append(std::to_string(instance.number)).append("=").append(instance.type).append("(");
    if (!instance.ignored.empty())
      text.append(arguments_without(instance.arguments, instance.ignored));
    else if (is_4x3)
      text.append(arguments_of_ifc4(instance));
    else
      text.append(instance.arguments);
    text.append(");\n");
  }
  return text + "ENDSEC;\n" + kEnd + "\n";
}

bool begins_like_step(const std::string& path) {
  const std::string head = first_bytes(path, kHead_bytes);
  std::string_view rest = trimmed(head);
  while (rest.starts_with("/*")) {
    const std::size_t end = rest.find("*/", 2);
    rest = end == std::string_view::npos ? std::string_view() : trimmed(rest.substr(end + 2));
  }
  return rest.substr(0, kMostRubbish + kFirst.size()).find(kFirst) != std::string_view::npos;
}

}  // namespace opal::ifc_importer
