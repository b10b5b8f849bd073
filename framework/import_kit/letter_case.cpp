#include <opal/import_kit/letter_case.hpp>

#include <cstdint>

namespace opal {
namespace {

/// One letter of UTF-8 with one or two bytes; longer ones have no case here.
struct Letter {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
};

Letter letter_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(at);
  if (first >= 0xC2 && first <= 0xDF && at + 1 < text.size() && (byte(at + 1) & 0xC0) == 0x80)
    return {(first & 0x1FU) << 6 | (byte(at + 1) & 0x3FU), 2};
  return {first, 1};
}

// It has no capital.
constexpr std::uint32_t kSharpS = 0xDF;

bool is_within(std::uint32_t code, std::uint32_t first, std::uint32_t last) { return code >= first && code <= last; }

/// By the blocks of Unicode: Latin-1, Latin Extended-A, Greek and Cyrillic.
std::uint32_t capital(const Letter& letter) {
  const std::uint32_t code = letter.code;
  if (letter.bytes == 1 && code > 127) return code;  // a byte of a longer letter
  if (is_within(code, 'a', 'z')) return code - 0x20;
  if (is_within(code, 0xE0, 0xFE) && code != 0xF7) return code - 0x20;
  if (is_within(code, 0x100, 0x137) && code != 0x131) return code & ~1U;
  if (is_within(code, 0x139, 0x148) || is_within(code, 0x179, 0x17E)) return code % 2 == 0 ? code - 1 : code;
  if (is_within(code, 0x14A, 0x177)) return code & ~1U;
  if (is_within(code, 0x3B1, 0x3C9) && code != 0x3C2) return code - 0x20;
  if (is_within(code, 0x430, 0x44F)) return code - 0x20;
  if (is_within(code, 0x450, 0x45F)) return code - 0x50;
  return code;
}

void append(std::uint32_t code, std::size_t bytes, std::string& text) {
  if (bytes == 2) text += static_cast<char>(0xC0 | code >> 6);
  text += static_cast<char>(bytes == 2 ? 0x80 | (code & 0x3F) : code);
}

bool is_letter(const Letter& letter) {
  return letter.bytes == 1 ? letter.code > 127 || is_within(capital(letter), 'A', 'Z')
                           : letter.code >= 0xC0 && letter.code != 0xD7 && letter.code != 0xF7;
}

}  // namespace

std::string upper_case_letters(const std::string& text) {
  std::string upper;
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    append(capital(letter), letter.bytes, upper);
    at += letter.bytes;
  }
  return upper;
}

std::vector<std::string> words_of_name(const std::string& name) {
  std::vector<std::string> words(1);
  bool was_small = false;
  for (std::size_t at = 0; at < name.size();) {
    const Letter letter = letter_at(name, at);
    const std::uint32_t upper = capital(letter);
    const bool is_capital = upper == letter.code && letter.code != kSharpS && (letter.bytes == 2 || letter.code < 128);
    if ((!is_letter(letter) || (was_small && is_capital)) && !words.back().empty()) words.emplace_back();
    if (is_letter(letter)) append(upper, letter.bytes, words.back());
    was_small = is_letter(letter) && upper != letter.code;
    at += letter.bytes;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

}  // namespace opal
