#include "lenient_json.hpp"

#include "json_lines.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

namespace opal::geojson_importer {
namespace {

// As Python, C and JavaScript write them.
constexpr std::array<std::string_view, 7> kNoNumbers{"NaN", "-Infinity", "Infinity", "nan", "-nan", "inf", "-inf"};

// Of texts that stand for no number: a character for private use, which no plan has.
constexpr std::string_view kMark = "\xEE\x80\x80";

/// Of a file that is not larger than a document may be; else nothing.
std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 1u << 16> block;
  while (text.size() <= JsonLimits{}.bytes && (file.read(block.data(), block.size()) || file.gcount() > 0))
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  return text.size() > JsonLimits{}.bytes ? "" : text;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string_view no_number_at(std::string_view text, std::size_t at) {
  if (at > 0 && is_letter(text[at - 1])) return {};
  for (const std::string_view word : kNoNumbers)
    if (text.substr(at).starts_with(word) && (at + word.size() == text.size() || !is_letter(text[at + word.size()])))
      return word;
  return {};
}

struct Quoted {
  std::string text;
  int count = 0;
  std::size_t first_line = 0;
};

/// With quotes around what is no number, outside of texts.
Quoted quoted(const std::string& text) {
  Quoted result;
  bool is_in_text = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const std::string_view word = is_in_text ? std::string_view() : no_number_at(text, k);
    if (word.empty()) {
      result.text += text[k];
      if (is_in_text && text[k] == '\\' && k + 1 < text.size())
        result.text += text[++k];
      else if (text[k] == '"')
        is_in_text = !is_in_text;
      continue;
    }
    if (result.count++ == 0)
      result.first_line =
          1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(k), '\n'));
    result.text += '"' + std::string(kMark) + std::string(word) + '"';
    k += word.size() - 1;
  }
  return result;
}

}  // namespace

nlohmann::json read_lenient_json(const std::string& path, std::vector<std::string>& notes) {
  try {
    return read_json(path);
  } catch (const JsonError& error) {
    const std::string text = text_of(path);
    if (auto lines = read_json_lines(text, path, notes)) return std::move(*lines);
    const Quoted lenient = quoted(text);
    if (lenient.count == 0) throw MapError(error.what());
    try {
      nlohmann::json document = parse_json(lenient.text, path);
      notes.push_back(
          fmt::format("damaged: NaN or Infinity in the place of a number, which is no JSON: {}, the first "
                      "in line {}",
                      lenient.count, lenient.first_line));
      return document;
    } catch (const JsonError&) {
      throw MapError(error.what());
    }
  }
}

std::string take_no_number(nlohmann::json& value) {
  if (value.is_string()) {
    auto& text = value.get_ref<std::string&>();
    if (!text.starts_with(kMark)) return "";
    text.erase(0, kMark.size());
    return ": " + text;
  }
  std::string first;
  if (value.is_structured())
    for (const auto& [key, part] : value.items())
      if (const std::string found = take_no_number(part); first.empty() && !found.empty())
        first = "/" + escape_pointer_step(key) + found;
  return first;
}

}  // namespace opal::geojson_importer
