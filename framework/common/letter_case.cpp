#include <opal/common/letter_case.hpp>

#include <utf8proc.h>

#include <algorithm>
#include <array>

namespace opal {
namespace {

/// A character of UTF-8, or a byte that is none.
struct Character {
  utf8proc_int32_t code = -1;  ///< -1: a byte that is no UTF-8
  std::string bytes;
};

Character character_at(const std::string& text, std::size_t at) {
  utf8proc_int32_t code = -1;
  const auto* begin = reinterpret_cast<const utf8proc_uint8_t*>(text.data() + at);
  const utf8proc_ssize_t length = utf8proc_iterate(begin, static_cast<utf8proc_ssize_t>(text.size() - at), &code);
  return length > 0 ? Character{code, text.substr(at, static_cast<std::size_t>(length))}
                    : Character{-1, text.substr(at, 1)};
}

using Case = utf8proc_int32_t (*)(utf8proc_int32_t);

std::string in_case(Case other, const Character& character) {
  if (character.code < 0) return character.bytes;
  std::array<utf8proc_uint8_t, 4> bytes{};
  const utf8proc_ssize_t length = utf8proc_encode_char(other(character.code), bytes.data());
  return {bytes.begin(), bytes.begin() + length};
}

std::string in_case(Case other, const std::string& text) {
  std::string changed;
  for (std::size_t at = 0; at < text.size();) {
    const Character character = character_at(text, at);
    changed += in_case(other, character);
    at += character.bytes.size();
  }
  return changed;
}

/// Of an alphabet or of signs, or an accent on the one before. What is no UTF-8 counts as one.
bool is_letter(const Character& character) {
  if (character.code < 0) return true;
  const utf8proc_category_t category = utf8proc_category(character.code);
  return category >= UTF8PROC_CATEGORY_LU && category <= UTF8PROC_CATEGORY_ME;
}

bool is_of(const Character& character, utf8proc_category_t category) {
  return character.code >= 0 && utf8proc_category(character.code) == category;
}

}  // namespace

std::string upper_case_letters(const std::string& text) { return in_case(utf8proc_toupper, text); }

std::string lower_case_letters(const std::string& text) { return in_case(utf8proc_tolower, text); }

std::vector<std::string> words_of_name(const std::string& name) {
  std::vector<std::string> words(1);
  bool was_small = false;
  for (std::size_t at = 0; at < name.size();) {
    const Character character = character_at(name, at);
    const bool begins = was_small && is_of(character, UTF8PROC_CATEGORY_LU);
    if ((begins || !is_letter(character)) && !words.back().empty()) words.emplace_back();
    if (is_letter(character)) words.back() += in_case(utf8proc_toupper, character);
    was_small = is_of(character, UTF8PROC_CATEGORY_LL);
    at += character.bytes.size();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool has_any_word(const std::vector<std::string>& words, std::span<const std::string_view> known) {
  return std::ranges::find_first_of(words, known) != words.end();
}

}  // namespace opal
