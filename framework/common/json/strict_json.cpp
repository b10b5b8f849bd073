#include "common/json/json_elements.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

namespace opal {
namespace {

using Json = nlohmann::json;

/// Builds the document from the parser's events, refusing what a plain parse would let through. The parser
/// calls iteratively, so the depth of a hostile text costs no stack.
class StrictBuilder : public nlohmann::json_sax<Json> {
 public:
  StrictBuilder(const std::string& text, const std::string& name, const JsonLimits& limits,
                const JsonElements* elements)
      : text_(text), name_(name), limits_(limits), elements_(elements) {}

  Json take() { return std::move(document_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { fail("a binary value, expected JSON text"); }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.key = std::move(name);
    if (level.value->contains(level.key)) fail("this key stands twice in one object, expected once");
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& error) override {
    throw JsonError(name_ + ": " + line_and_column(byte) + ": " + without_prefix(error.what()));
  }

 private:
  struct Level {
    Json* value;
    std::string key;
  };

  bool add(Json value) {
    place(std::move(value));
    return true;
  }

  bool open(Json empty) {
    if (static_cast<int>(levels_.size()) >= limits_.depth)
      fail("nested more deeply than expected, at most " + std::to_string(limits_.depth) + " levels");
    levels_.push_back({place(std::move(empty)), {}});
    return true;
  }

  bool close() {
    levels_.pop_back();
    if (elements_ != nullptr && is_among_elements()) {
      Json& array = *levels_[1].value;
      if (elements_->take(array.back())) array.erase(array.size() - 1);
    }
    return true;
  }

  /// What was closed is an element of the array whose elements somebody takes.
  bool is_among_elements() const {
    return levels_.size() == 2 && levels_[0].value->is_object() && levels_[0].key == elements_->key &&
           levels_[1].value->is_array();
  }

  Json* place(Json value) {
    if (levels_.empty()) return &(document_ = std::move(value));
    Level& level = levels_.back();
    if (level.value->is_object()) return &((*level.value)[level.key] = std::move(value));
    level.value->push_back(std::move(value));
    return &level.value->back();
  }

  std::string pointer() const {
    std::string result;
    for (const Level& level : levels_) {
      const bool object = level.value->is_object();
      // The innermost array is about to grow; in the others the last element is the one being read.
      const std::size_t index = level.value->size() - (&level == &levels_.back() ? 0 : 1);
      result += '/' + (object ? escape_pointer_step(level.key) : std::to_string(index));
    }
    constexpr std::size_t kLongest = 200;  // of a place that a person reads
    if (result.size() > kLongest) result = result.substr(0, kLongest) + "...";
    return result.empty() ? "(root)" : result;
  }

  [[noreturn]] void fail(const std::string& found_and_expected) const {
    throw JsonError(name_ + ": " + pointer() + ": " + found_and_expected);
  }

  /// @param byte  1-based offset, as the parser counts.
  std::string line_and_column(std::size_t byte) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(byte > 0 ? byte - 1 : 0, text_.size()));
    const auto line = 1 + std::count(text_.begin(), end, '\n');
    const auto line_start =
        std::find(std::make_reverse_iterator(end), std::make_reverse_iterator(text_.begin()), '\n').base();
    return "line " + std::to_string(line) + ", column " + std::to_string(1 + (end - line_start));
  }

  /// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..." without its first
  /// part, which names the library and counts columns its own way.
  static std::string without_prefix(const std::string& message) {
    const std::size_t column = message.find(", column ");
    const std::size_t colon = message.find(": ", column == std::string::npos ? 0 : column);
    if (column != std::string::npos && colon != std::string::npos) return message.substr(colon + 2);
    const std::size_t bracket = message.find("] ");
    return bracket == std::string::npos ? message : message.substr(bracket + 2) + ", expected a finite number";
  }

  const std::string& text_;
  const std::string& name_;
  const JsonLimits limits_;
  const JsonElements* elements_;  ///< null: nobody takes any
  Json document_;
  std::vector<Level> levels_;
};

void require_plausible_text(const std::string& text, const std::string& name, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    throw JsonError(name + ": (root): more bytes than expected, at most " + std::to_string(limits.bytes));
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw JsonError(name + ": line 1, column 1: no content, expected a JSON value");
  // The parser takes a NUL for the end of the text and would not look at what follows.
  const std::size_t nul = text.find('\0');
  if (nul != std::string::npos)
    throw JsonError(name + ": byte " + std::to_string(nul + 1) + ": a NUL byte, expected JSON text");
}

/// @param elements  null: nobody takes any.
Json parsed(const std::string& text, const std::string& name, const JsonLimits& limits, const JsonElements* elements) {
  require_plausible_text(text, name, limits);
  StrictBuilder builder(text, name, limits, elements);
  Json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace

JsonError::~JsonError() = default;

Json parse_json(const std::string& text, const std::string& name, const JsonLimits& limits) {
  return parsed(text, name, limits, nullptr);
}

Json parse_json_elements(const std::string& text, const std::string& name, const JsonElements& elements,
                         const JsonLimits& limits) {
  return parsed(text, name, limits, &elements);
}

Json read_json(const std::string& path, const JsonLimits& limits) {
  return parse_json(read_json_text(path, limits), path, limits);
}

std::string read_json_text(const std::string& path, const JsonLimits& limits) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw JsonError(path + ": cannot be opened: " + std::strerror(errno) + ", expected a readable JSON file");
  if (std::filesystem::is_directory(path)) throw JsonError(path + ": is a folder, expected a JSON file");
  // Read at most one byte too many: the size of a pipe or device is not known beforehand.
  std::string text;
  std::vector<char> block(1u << 16);
  while (text.size() <= limits.bytes &&
         (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0))
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  if (file.bad()) throw JsonError(path + ": cannot be read, expected a readable JSON file");
  return text;
}

std::string escape_pointer_step(const std::string& key) {
  std::string result;
  for (const char c : key) {
    if (c == '~')
      result += "~0";
    else if (c == '/')
      result += "~1";
    else
      result += c;
  }
  return result;
}

}  // namespace opal
