#include "dxf_encoding.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include <iconv.h>

namespace opal::dxf_importer {
namespace {

constexpr std::size_t kEscape = 7;  // characters of "\U+00C4"

/// How many bytes a character of UTF-8 has that begins here; 0: none does.
std::size_t length_of_character(const std::string& text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                             : lead >= 0xE0                ? 3
                             : lead >= 0xC2                ? 2
                                                           : 0;
  if (length == 0 || lead >= 0xF5 || at + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((static_cast<unsigned char>(text[at + k]) & 0xC0) != 0x80) return 0;
  return length;
}

bool is_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of_character(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

/// "CP1252" of the header variable's "ANSI_1252"; other names are as iconv has them.
std::string code_page_of(const std::string& text) {
  const std::size_t variable = text.find("$DWGCODEPAGE");
  const std::size_t prefix = variable == std::string::npos ? variable : text.find("ANSI_", variable);
  if (prefix == std::string::npos || prefix - variable > 40) return "CP1252";
  const std::size_t digits = prefix + 5, end = text.find_first_not_of("0123456789", digits);
  return "CP" + text.substr(digits, std::min(end, digits + 5) - digits);
}

class CodePage {
 public:
  explicit CodePage(const std::string& name) : converter_(iconv_open("UTF-8", name.c_str())) {}
  ~CodePage() {
    if (is_known()) iconv_close(converter_);
  }
  CodePage(const CodePage&) = delete;
  CodePage& operator=(const CodePage&) = delete;

  bool is_known() const { return reinterpret_cast<std::intptr_t>(converter_) != -1; }

  std::string to_utf8(std::string text) const {
    std::string converted(4 * text.size(), '\0');
    char *in = text.data(), *out = converted.data();
    std::size_t left = text.size(), room = converted.size();
    while (left > 0 && iconv(converter_, &in, &left, &out, &room) == static_cast<std::size_t>(-1) && left > 0) {
      *out++ = '?';
      --room, ++in, --left;
    }
    converted.resize(converted.size() - room);
    return converted;
  }

 private:
  iconv_t converter_;
};

void append_utf8(std::uint32_t character, std::string& text) {
  if (character < 0x80) {
    text += static_cast<char>(character);
  } else if (character < 0x800) {
    text += static_cast<char>(0xC0 | (character >> 6));
    text += static_cast<char>(0x80 | (character & 0x3F));
  } else {
    text += static_cast<char>(0xE0 | (character >> 12));
    text += static_cast<char>(0x80 | ((character >> 6) & 0x3F));
    text += static_cast<char>(0x80 | (character & 0x3F));
  }
}

/// The character that an escape at this place stands for; 0: there is none.
std::uint32_t escaped_character(const std::string& text, std::size_t at) {
  if (text.compare(at, 3, "\\U+") != 0 || at + kEscape > text.size()) return 0;
  std::uint32_t character = 0;
  const char* const end = text.data() + at + kEscape;
  const bool is_number = std::from_chars(end - 4, end, character, 16).ptr == end;
  const bool is_half_of_a_pair = character >= 0xD800 && character < 0xE000;
  return is_number && character >= 0x20 && !is_half_of_a_pair ? character : 0;
}

std::string unescaped(const std::string& text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t character = escaped_character(text, at);
    if (character == 0)
      plain += text[at++];
    else
      append_utf8(character, plain), at += kEscape;
  }
  return plain;
}

/// The name of the encoding of text whose characters have two bytes, by its mark or its first two characters; empty: it
/// is another one.
std::string utf16_of(const std::string& text) {
  const auto is_letter = [&](std::size_t at) { return text[at] > 0 && text[at] < 127; };
  if (text.starts_with("\xFF\xFE")) return "UTF-16LE";
  if (text.starts_with("\xFE\xFF")) return "UTF-16BE";
  if (text.size() < 4) return "";
  if (is_letter(0) && text[1] == 0 && is_letter(2) && text[3] == 0) return "UTF-16LE";
  return text[0] == 0 && is_letter(1) && text[2] == 0 && is_letter(3) ? "UTF-16BE" : "";
}

}  // namespace

std::string as_utf8(const std::string& given) {
  const std::string wide = utf16_of(given);
  const std::string text = wide.empty() ? given : CodePage(wide).to_utf8(given);
  std::string readable = text;
  if (!is_utf8(text)) {
    const CodePage code_page(code_page_of(text));
    readable = code_page.is_known() ? code_page.to_utf8(text) : CodePage("ISO-8859-1").to_utf8(text);
  }
  return readable.find("\\U+") == std::string::npos ? readable : unescaped(readable);
}

}  // namespace opal::dxf_importer
