#include "foreign_letters.hpp"

#include <opal/common/file_start.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace opal::ifc_importer {
namespace {

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// The letter at a place of a text in UTF-8, and how many bytes it has; none: it is no UTF-8 there.
struct Letter {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

Letter letter_at(const std::string& text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  const std::size_t bytes = lead >= 0xF0 && lead < 0xF5   ? 4
                            : lead >= 0xE0 && lead < 0xF0 ? 3
                            : lead >= 0xC2 && lead < 0xE0 ? 2
                                                          : 0;
  if (bytes == 0 || at + bytes > text.size()) return {};
  std::uint32_t code = lead & (0xFFu >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    const auto next = static_cast<unsigned char>(text[at + k]);
    if ((next & 0xC0) != 0x80) return {};
    code = code << 6 | (next & 0x3Fu);
  }
  return {code, bytes};
}

bool is_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = is_ascii(text[at]) ? 1 : letter_at(text, at).bytes;
    if (bytes == 0) return false;
    at += bytes;
  }
  return true;
}

}  // namespace

std::string with_codes(std::string text) {
  erase_byte_order_mark(text);
  if (std::all_of(text.begin(), text.end(), is_ascii)) return text;
  const bool is_unicode = is_utf8(text);
  std::string coded;
  coded.reserve(text.size() + text.size() / 8);
  for (std::size_t at = 0; at < text.size();) {
    if (is_ascii(text[at])) {
      coded += text[at++];
      continue;
    }
    const Letter letter = is_unicode ? letter_at(text, at) : Letter{static_cast<unsigned char>(text[at]), 1};
    if (letter.code < 0x10000)
      fmt::format_to(std::back_inserter(coded), "\\X2\\{:04X}\\X0\\", letter.code);
    else
      fmt::format_to(std::back_inserter(coded), "\\X4\\{:08X}\\X0\\", letter.code);
    at += letter.bytes;
  }
  return coded;
}

}  // namespace opal::ifc_importer
